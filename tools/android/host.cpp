// Starts an Android program inside a process of glibc, as the kernel would, and lends it the host's EGL and
// OpenGL ES:
//
//     host LINKER PROGRAM [ARGUMENT...]
//
// LINKER is Android's linker64. The program's environment has the variables that begin with ANDROID_ENV_,
// without that.
//
// Each of the two C libraries expects its own data behind the thread pointer. So the program calls a function
// of the host through a few generated instructions, which set the thread pointer to that of a thread of glibc
// that does nothing else, and set it back.
#include "host.h"

#include <dlfcn.h>
#include <elf.h>
#include <link.h>
#include <pthread.h>
#include <sys/auxv.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <mutex>
#include <string>
#include <vector>

namespace {

using host::Call;

static_assert(offsetof(Call, savedRegister) == 8 && offsetof(Call, androidThread) == 16 &&
              offsetof(Call, hostThread) == 24 && offsetof(Call, platformRegister) == 32 &&
              host::threadSlot == 3);

[[noreturn]] void fail(const std::string& message) {
    std::fprintf(stderr, "host: error: %s\n", message.c_str());
    _exit(111);
}

std::uint8_t* mapMemory(std::size_t size, int protection) {
    void* const memory = mmap(nullptr, size, protection, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (memory == MAP_FAILED) fail("out of memory");
    return static_cast<std::uint8_t*>(memory);
}

#if defined(__x86_64__)

std::uint64_t threadPointer() {
    std::uint64_t value = 0;
    __asm__ volatile("rdfsbase %0" : "=r"(value));
    return value;
}

// Calls the function whose address follows.
constexpr std::array<std::uint8_t, 56> callCode = {
    0x64, 0x4c, 0x8b, 0x1c, 0x25, 24, 0, 0, 0,  // mov r11, fs:[8 * threadSlot]
    0x41, 0x8f, 0x03,                           // pop [r11]
    0x49, 0x89, 0x5b, 8,                        // mov [r11 + 8], rbx
    0x4c, 0x89, 0xdb,                           // mov rbx, r11
    0x4c, 0x8b, 0x5b, 24,                       // mov r11, [rbx + 24]
    0xf3, 0x49, 0x0f, 0xae, 0xd3,               // wrfsbase r11
    0x41, 0xff, 0x15, 21,   0,    0,  0,        // call [rip + 21]
    0x4c, 0x8b, 0x5b, 16,                       // mov r11, [rbx + 16]
    0xf3, 0x49, 0x0f, 0xae, 0xd3,               // wrfsbase r11
    0x49, 0x89, 0xdb,                           // mov r11, rbx
    0x49, 0x8b, 0x5b, 8,                        // mov rbx, [r11 + 8]
    0x41, 0xff, 0x23,                           // jmp [r11]
    0xcc, 0xcc,                                 // the address is aligned to 8
};

[[noreturn]] void jump(std::uintptr_t entry, std::uint64_t* stack) {
    __asm__ volatile("mov %0, %%rsp; xor %%edx, %%edx; xor %%ebp, %%ebp; jmp *%1"
                     :
                     : "r"(stack), "r"(entry)
                     : "memory", "rdx");
    __builtin_unreachable();
}

#elif defined(__aarch64__)

std::uint64_t threadPointer() {
    std::uint64_t value = 0;
    __asm__ volatile("mrs %0, tpidr_el0" : "=r"(value));
    return value;
}

// Calls the function whose address follows.
constexpr std::array<std::uint32_t, 18> callCode = {
    0xd53bd050,  // mrs x16, tpidr_el0
    0xf9400e10,  // ldr x16, [x16, 8 * threadSlot]
    0xf900021e,  // str x30, [x16]
    0xf9000613,  // str x19, [x16, 8]
    0xf9001212,  // str x18, [x16, 32]
    0xaa1003f3,  // mov x19, x16
    0xf9400e71,  // ldr x17, [x19, 24]
    0xd51bd051,  // msr tpidr_el0, x17
    0x58000151,  // ldr x17, the address
    0xd63f0220,  // blr x17
    0xf9400a71,  // ldr x17, [x19, 16]
    0xd51bd051,  // msr tpidr_el0, x17
    0xaa1303f0,  // mov x16, x19
    0xf9401212,  // ldr x18, [x16, 32]
    0xf940021e,  // ldr x30, [x16]
    0xf9400613,  // ldr x19, [x16, 8]
    0xd65f03c0,  // ret
    0xd503201f,  // nop: the address is aligned to 8
};

[[noreturn]] void jump(std::uintptr_t entry, std::uint64_t* stack) {
    __asm__ volatile("mov sp, %0; mov x0, xzr; mov x29, xzr; mov x30, xzr; br %1"
                     :
                     : "r"(stack), "r"(entry)
                     : "memory", "x0");
    __builtin_unreachable();
}

#endif

// Generates the code that calls a function of the host.
void* callable(void* function) {
    constexpr std::size_t codeSize = sizeof callCode, size = (codeSize + 8 + 15) / 16 * 16, maxCount = 10000;
    static std::uint8_t* const memory = mapMemory(size * maxCount, PROT_READ | PROT_WRITE | PROT_EXEC);
    static std::atomic<std::size_t> count{0};
    const std::size_t index = count++;
    if (index >= maxCount) fail("no room for more functions");
    std::uint8_t* const code = memory + size * index;
    std::memcpy(code, callCode.data(), codeSize);
    std::memcpy(code + (codeSize + 7) / 8 * 8, &function, sizeof function);
    __builtin___clear_cache(reinterpret_cast<char*>(code), reinterpret_cast<char*>(code + size));
    return code;
}

host::Host shared;
pthread_barrier_t threadsWait;

void* waitForever(void* call) {
    static_cast<Call*>(call)->hostThread = threadPointer();
    pthread_barrier_wait(&threadsWait);
    for (;;)
        pause();
}

void startThreads() {
    pthread_barrier_init(&threadsWait, nullptr, host::maxThreads + 1);
    for (Call& call : shared.calls) {
        pthread_t thread{};
        if (pthread_create(&thread, nullptr, waitForever, &call) != 0) fail("cannot create a thread");
    }
    pthread_barrier_wait(&threadsWait);
}

void* findFunction(const char* name) {
    static void* const egl = dlopen("libEGL.so.1", RTLD_NOW | RTLD_GLOBAL);
    if (egl == nullptr) fail(dlerror());
    using GetProcAddress = void* (*)(const char*);
    static const auto getProcAddress = reinterpret_cast<GetProcAddress>(dlsym(egl, "eglGetProcAddress"));
    void* const function = std::strncmp(name, "egl", 3) == 0 ? dlsym(egl, name) : getProcAddress(name);
    return function == nullptr ? nullptr : callable(function);
}

struct Image {
    std::uintptr_t base = 0, entry = 0, headers = 0;
    std::size_t headerCount = 0;
};

// Copies a position-independent program into memory.
Image load(const char* path) {
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes(std::istreambuf_iterator<char>(file), {});
    const auto* const header = reinterpret_cast<const ElfW(Ehdr)*>(bytes.data());
    if (bytes.size() < sizeof *header || std::memcmp(header->e_ident, ELFMAG, SELFMAG) != 0)
        fail(std::string(path) + " is not a program");
    const auto* const first = reinterpret_cast<const ElfW(Phdr)*>(bytes.data() + header->e_phoff);
    const auto* const last = first + header->e_phnum;
    std::size_t end = 0;
    for (const auto* segment = first; segment != last; ++segment)
        if (segment->p_type == PT_LOAD) end = std::max(end, segment->p_vaddr + segment->p_memsz);
    constexpr std::size_t maxPage = 65536;
    auto base = reinterpret_cast<std::uintptr_t>(mapMemory(end + 2 * maxPage, PROT_READ | PROT_WRITE));
    base = (base + maxPage - 1) / maxPage * maxPage;
    Image image{base, base + header->e_entry, base + header->e_phoff, header->e_phnum};
    for (const auto* segment = first; segment != last; ++segment) {
        auto* const memory = reinterpret_cast<char*>(base + segment->p_vaddr);
        if (segment->p_type == PT_PHDR) image.headers = base + segment->p_vaddr;
        if (segment->p_type != PT_LOAD) continue;
        std::memcpy(memory, bytes.data() + segment->p_offset, segment->p_filesz);
        __builtin___clear_cache(memory, memory + segment->p_memsz);
    }
    const std::uintptr_t page = getauxval(AT_PAGESZ);
    for (const auto* segment = first; segment != last; ++segment) {
        if (segment->p_type != PT_LOAD) continue;
        const std::uintptr_t from = (base + segment->p_vaddr) / page * page;
        const int protection = ((segment->p_flags & PF_R) != 0 ? PROT_READ : 0) |
                               ((segment->p_flags & PF_W) != 0 ? PROT_WRITE : 0) |
                               ((segment->p_flags & PF_X) != 0 ? PROT_EXEC : 0);
        mprotect(reinterpret_cast<void*>(from), base + segment->p_vaddr + segment->p_memsz - from,
                 protection);
    }
    return image;
}

// Writes arguments, environment and auxiliary vector as the kernel lays them out, and returns the stack
// pointer.
std::uint64_t* makeStack(const std::vector<std::string>& arguments,
                         const std::vector<std::string>& environment, const Image& linker,
                         const Image& program) {
    constexpr std::size_t size = 64 << 20, tables = 1 << 20, strings = 1 << 20;
    std::uint8_t* const memory = mapMemory(size, PROT_READ | PROT_WRITE);
    auto* text = reinterpret_cast<char*>(memory + size - strings);
    auto* const stack = reinterpret_cast<std::uint64_t*>(memory + size - strings - tables);
    std::uint64_t* next = stack;
    const auto append = [&](const std::string& string) {
        *next++ = reinterpret_cast<std::uint64_t>(std::strcpy(text, string.c_str()));
        text += string.size() + 1;
    };
    *next++ = arguments.size();
    std::for_each(arguments.begin(), arguments.end(), append);
    *next++ = 0;
    std::for_each(environment.begin(), environment.end(), append);
    *next++ = 0;
    for (const unsigned long type : {AT_HWCAP, AT_HWCAP2, AT_PAGESZ, AT_CLKTCK, AT_UID, AT_EUID, AT_GID,
                                     AT_EGID, AT_SECURE, AT_RANDOM, AT_SYSINFO_EHDR, AT_PLATFORM}) {
        *next++ = type;
        *next++ = getauxval(type);
    }
    for (const std::uint64_t value :
         {std::uint64_t{AT_PHDR}, program.headers, std::uint64_t{AT_PHENT}, sizeof(ElfW(Phdr)),
          std::uint64_t{AT_PHNUM}, program.headerCount, std::uint64_t{AT_BASE}, linker.base,
          std::uint64_t{AT_ENTRY}, program.entry, std::uint64_t{AT_EXECFN}, stack[1], std::uint64_t{AT_NULL},
          std::uint64_t{0}})
        *next++ = value;
    return stack;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) fail("usage: host LINKER PROGRAM [ARGUMENT...]");
    startThreads();
    findFunction("eglGetProcAddress");  // loads the libraries while the main thread still belongs to glibc
    shared.find = reinterpret_cast<void* (*)(const char*)>(callable(reinterpret_cast<void*>(findFunction)));

    std::vector<std::string> environment;
    const std::string prefix = "ANDROID_ENV_";
    for (char** variable = environ; *variable != nullptr; ++variable)
        if (prefix.compare(0, prefix.size(), *variable, prefix.size()) == 0)
            environment.emplace_back(*variable + prefix.size());
    char address[32];
    std::snprintf(address, sizeof address, "%llx",
                  static_cast<unsigned long long>(reinterpret_cast<std::uintptr_t>(&shared)));
    environment.push_back(host::variable + std::string("=") + address);
    const Image linker = load(argv[1]), program = load(argv[2]);
    jump(linker.entry, makeStack({argv + 2, argv + argc}, environment, linker, program));
}
