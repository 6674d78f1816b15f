// The memory that host.cpp shares with the Android program inside it. No type here belongs to one of the two
// C libraries.
#pragma once

#include <cstdint>

namespace host {

// The state of a call from an Android thread to the host. Generated code uses the offsets of its members.
struct Call {
    std::uint64_t returnAddress;
    std::uint64_t savedRegister;  // rbx or x19
    std::uint64_t androidThread;  // values of the thread pointer
    std::uint64_t hostThread;
    std::uint64_t platformRegister;  // x18, which Android keeps and glibc does not
};

// The element of Android's thread-local storage that has the address of the thread's Call. Android reserves
// it for OpenGL.
constexpr int threadSlot = 3;
constexpr int maxThreads = 16;

struct Host {
    // The function of the host's EGL or OpenGL ES with this name, or null. It and its results may be called
    // by a thread whose slot is set.
    void* (*find)(const char* name);
    std::int32_t threadCount;  // how many of the calls have an Android thread
    Call calls[maxThreads];
};

// The environment variable with the address of the Host, in hexadecimal digits.
constexpr const char* variable = "VCT_HOST";

}  // namespace host
