// The buffer that driver checks write (jni/lab/driver_checks.cpp): words for the CPU, and the size of a
// dispatch.
layout(std430, binding = 0) buffer CheckBlock {
    uint groups[4];  // DispatchIndirectCommand, and one unused word
    uint words[64];
};
