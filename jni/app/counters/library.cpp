#include "app/counters/library.h"

#include <hwcpipe/gpu.hpp>
#include <hwcpipe/sampler.hpp>
#include <memory>
#include <string>
#include <system_error>

namespace {

std::unique_ptr<hwcpipe::sampler<>> sampler;
std::string failure;

const char* fail(const std::string& what, const std::error_code& error) {
    failure = what + ": " + error.message();
    return failure.c_str();
}

double valueOf(hwcpipe_counter counter, std::error_code& error) {
    hwcpipe::counter_sample sample;
    if (const std::error_code failed = sampler->get_counter_value(counter, sample)) error = failed;
    return sample.type == hwcpipe::counter_sample::type::uint64 ? static_cast<double>(sample.value.uint64)
                                                                : sample.value.float64;
}

}  // namespace

const char* vctStartCounters() {
    if (sampler) return nullptr;
    const hwcpipe::gpu gpu(0);
    if (!gpu)
        return "the device has no /dev/mali0 that the app may open, with a Mali-G71 or a newer GPU of Arm";
    hwcpipe::sampler_config config(gpu);
    for (const hwcpipe_counter counter : {MaliGPUActiveCy, MaliExtBusRdBy, MaliExtBusWrBy})
        if (const std::error_code error = config.add_counter(counter))
            return fail("libGPUCounters does not know a counter of this GPU", error);
    auto started = std::make_unique<hwcpipe::sampler<>>(config);
    if (const std::error_code error = started->start_sampling())
        return fail("the driver does not let the app read counters", error);
    sampler = std::move(started);
    return nullptr;
}

const char* vctReadCounters(VctCounts* counts) {
    if (const std::error_code error = sampler->sample_now())
        return fail("the driver gave no counters", error);
    std::error_code error;
    *counts = {valueOf(MaliGPUActiveCy, error), valueOf(MaliExtBusRdBy, error),
               valueOf(MaliExtBusWrBy, error)};
    return error ? fail("the driver gave no counters", error) : nullptr;
}
