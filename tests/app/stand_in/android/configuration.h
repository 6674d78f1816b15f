#pragma once

#include <cstdint>

struct AConfiguration;
enum { ACONFIGURATION_DENSITY_ANY = 0xfffe };
int32_t AConfiguration_getDensity(AConfiguration* configuration);
