#pragma once

#include <cstddef>
#include <cstdint>

struct AAssetManager;
struct AAsset;
struct AAssetDir;
enum { AASSET_MODE_STREAMING = 2 };
AAsset* AAssetManager_open(AAssetManager* manager, const char* name, int mode);
AAssetDir* AAssetManager_openDir(AAssetManager* manager, const char* name);
int64_t AAsset_getLength64(AAsset* asset);
int AAsset_read(AAsset* asset, void* buffer, size_t count);
void AAsset_close(AAsset* asset);
const char* AAssetDir_getNextFileName(AAssetDir* folder);
void AAssetDir_close(AAssetDir* folder);
