// What the checks of a driver write (jni/lab/driver_checks.cpp): words that the CPU reads, and a dispatch's size.
layout(std430, binding = 0) buffer CheckBlock {
    uint groups[4];  // DispatchIndirectCommand, and nothing
    uint words[64];
};
