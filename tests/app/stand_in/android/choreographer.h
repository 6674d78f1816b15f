#pragma once

struct AChoreographer;
typedef void (*AChoreographer_frameCallback)(long frameTimeNanos, void* data);

AChoreographer* AChoreographer_getInstance();
void AChoreographer_postFrameCallback(AChoreographer* choreographer, AChoreographer_frameCallback callback,
                                      void* data);
