#pragma once

void ATrace_beginSection(const char* name);
void ATrace_endSection();
