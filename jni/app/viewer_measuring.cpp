// The viewer's measurements, one frame at a time: the self-test of the driver at the start, and the benchmark
// that a command or the panel asks for.
#include "app/log.h"
#include "app/viewer.h"
#include "core/error.h"
#include "lab/options.h"
#include "scene/camera.h"
#include "scene/light_choice.h"

namespace vct::app {

std::optional<SelfTestResult>& passedSelfTest() {
    static std::optional<SelfTestResult> result;
    return result;
}

// Runs a part of the self-test in each frame, after the first frame was shown, until there is a result.
void Viewer::testDriver() {
    const bool waitsForPicture = !host_.testsDriverFirst && scene_ && !good_ && !failed_ && !request_;
    if (testResult_ || shownFrames_ == 0 || waitsForPicture) return;
    if (passedSelfTest()) {
        testResult_ = passedSelfTest();
        log(LogLevel::detail, "self-test passed earlier in this process");
        return;
    }
    if (!selfTest_)
        selfTest_ = std::make_unique<SelfTest>(gl_->capabilities(), host_.shaders, gl_->programs());
    if (selfTest_->advance()) return;
    testResult_ = selfTest_->result();
    selfTest_.reset();
    const std::string text =
        (testResult_->passed ? "self-test passed: " : "self-test FAILED: ") + testResult_->text;
    if (testResult_->passed) {
        passedSelfTest() = testResult_;
        log(LogLevel::detail, text);
    } else {
        fail(text);
    }
}

void Viewer::startMeasuring(const std::string& command) {
    log(command);
    try {
        results_ = std::make_unique<ResultsFolder>(host_.folder + "/results");
        BenchRequest request = benchRequestFromText(command);
        scenes_.rescan();
        const int index = scenes_.find(request.scene.empty() ? scenePath() : request.scene);
        if (index < 0)
            throw Error("there is no scene '" + request.scene + "'; copy it into the folder " + host_.folder);
        const FileChoice& found = scenes_.all()[index];
        request.scene = found.name;
        if (found.path != scenePath()) scenes_.load(found);
        request_ = request;
        host_.keepScreenOn(true);
    } catch (const std::exception& error) {
        endMeasuring(error.what());
    }
}

// Renders one frame of the measurement.
void Viewer::measure() {
    bool more = true;
    const std::string failure = failureOf([&] {
        if (!bench_) {
            gl_->dropRenderer();
            stepMs_.reset();
            Settings sky;
            // As `vct bench`, the app measures a scene with a sun without a sky.
            if (request_->light.empty() && scene_->lights.empty())
                sky.skyRadiance = chooseSky(*scene_, chooseLight(*scene_));
            bench_ = std::make_unique<BenchRun>(
                BenchRun::Input{*request_, scene_, lightFromText(request_->light, *scene_), sky,
                                gl_->capabilities(), host_.shaders, host_.backend, selfTestJson(*testResult_),
                                [](const std::string& line) { log(line); }, gl_->programs()},
                results_->path());
        }
        more = bench_->advance();
    });
    if (!failure.empty() || !more) endMeasuring(failure);
}

void Viewer::endMeasuring(const std::string& failure) {
    bench_.reset();
    request_.reset();
    host_.keepScreenOn(false);
    if (failure.empty()) {
        message_ = "measured: the results are in the folder " + host_.folder + "/results";
        log(message_);
    } else {
        fail("measuring failed: " + failure);
    }
    try {
        if (results_ && failure.empty()) results_->done(testResult_->text);
        if (results_ && !failure.empty()) results_->failed(failure);
    } catch (const Error& error) {
        fail(error.what());
    }
    results_.reset();
}

}  // namespace vct::app
