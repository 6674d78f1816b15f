// A stand-in for Android's libandroid.so: the loop that a thread waits in, the display's refresh signal and
// input.
#include <android/choreographer.h>
#include <android/looper.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include <cerrno>
#include <deque>
#include <memory>
#include <utility>

#include "stand_in.h"

using stand_in::reportMisuse;
using stand_in::state;

struct ALooper {
    struct Source {
        int fd, ident;
        ALooper_callbackFunc callback;
        void* data;
    };
    ~ALooper() { close(wakeFd); }

    std::mutex mutex;
    std::vector<Source> sources;
    std::deque<Source> ready;  // sources with events, which pollOnce returns one by one
    int wakeFd = eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
};

struct AChoreographer {
    ~AChoreographer() { close(fd); }

    int fd = timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC);
    std::vector<std::pair<AChoreographer_frameCallback, void*>> callbacks;
};

struct AInputQueue {
    std::mutex mutex;
    std::deque<AInputEvent*> events;
    int fd = eventfd(0, EFD_NONBLOCK | EFD_SEMAPHORE | EFD_CLOEXEC);
    ALooper* looper = nullptr;
};

namespace {

constexpr std::int64_t refreshNs = 1'000'000'000 / 60;

thread_local std::unique_ptr<ALooper> looper;
thread_local std::unique_ptr<AChoreographer> choreographer;

// Adds 1 to the counter that `fd` is, or takes from it.
void signal(int fd) {
    const std::uint64_t one = 1;
    [[maybe_unused]] const ssize_t written = write(fd, &one, sizeof one);
}
bool take(int fd) {
    std::uint64_t count = 0;
    return read(fd, &count, sizeof count) == sizeof count;
}

void removeSource(ALooper& from, int fd) {
    const std::lock_guard lock(from.mutex);
    std::erase_if(from.sources, [fd](const ALooper::Source& source) { return source.fd == fd; });
}

std::int64_t nowNs() {
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec * std::int64_t{1'000'000'000} + time.tv_nsec;
}

int onRefresh(int fd, int, void*) {
    if (!take(fd)) return 1;
    const std::int64_t timeNs = nowNs() / refreshNs * refreshNs;
    for (const auto& [callback, data] : std::exchange(choreographer->callbacks, {}))
        callback(static_cast<long>(timeNs), data);
    return 1;
}

// Waits for events, calls the callbacks of their sources, and notes the other sources in `ready`.
int wait(ALooper& own, int timeoutMs) {
    std::vector<ALooper::Source> sources;
    {
        const std::lock_guard lock(own.mutex);
        sources = own.sources;
    }
    std::vector<pollfd> fds;
    for (const ALooper::Source& source : sources)
        fds.push_back({source.fd, POLLIN, 0});
    fds.push_back({own.wakeFd, POLLIN, 0});
    const int count = poll(fds.data(), fds.size(), timeoutMs);
    if (count < 0 && errno != EINTR) return ALOOPER_POLL_ERROR;
    if (count == 0) return ALOOPER_POLL_TIMEOUT;
    take(own.wakeFd);
    int result = ALOOPER_POLL_WAKE;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        if (fds[i].revents == 0) continue;
        const ALooper::Source& source = sources[i];
        if (source.callback == nullptr) {
            own.ready.push_back(source);
            continue;
        }
        if (source.callback(source.fd, ALOOPER_EVENT_INPUT, source.data) == 0) removeSource(own, source.fd);
        result = ALOOPER_POLL_CALLBACK;
    }
    return result;
}

}  // namespace

AInputQueue* stand_in::createInputQueue() {
    return new AInputQueue;
}

void stand_in::send(AInputQueue* queue, AInputEvent* event) {
    {
        const std::lock_guard lock(queue->mutex);
        queue->events.push_back(event);
    }
    signal(queue->fd);
}

extern "C" {

ALooper* ALooper_prepare(int) {
    if (!looper) looper = std::make_unique<ALooper>();
    return looper.get();
}

int ALooper_addFd(ALooper* to, int fd, int ident, int, ALooper_callbackFunc callback, void* data) {
    removeSource(*to, fd);
    const std::lock_guard lock(to->mutex);
    to->sources.push_back({fd, callback != nullptr ? ALOOPER_POLL_CALLBACK : ident, callback, data});
    signal(to->wakeFd);
    return 1;
}

int ALooper_pollOnce(int timeoutMs, int* outFd, int* outEvents, void** outData) {
    if (!looper) {
        reportMisuse("a thread without a looper waits for events");
        return ALOOPER_POLL_ERROR;
    }
    const int result = looper->ready.empty() ? wait(*looper, timeoutMs) : ALOOPER_POLL_WAKE;
    ALooper::Source source{0, result, nullptr, nullptr};
    if (!looper->ready.empty()) {
        source = looper->ready.front();
        looper->ready.pop_front();
    }
    if (outFd != nullptr) *outFd = source.fd;
    if (outEvents != nullptr) *outEvents = source.ident >= 0 ? ALOOPER_EVENT_INPUT : 0;
    if (outData != nullptr) *outData = source.data;
    return source.ident;
}

AChoreographer* AChoreographer_getInstance() {
    if (!looper) return nullptr;
    if (!choreographer) {
        choreographer = std::make_unique<AChoreographer>();
        ALooper_addFd(looper.get(), choreographer->fd, 0, ALOOPER_EVENT_INPUT, onRefresh, nullptr);
    }
    return choreographer.get();
}

void AChoreographer_postFrameCallback(AChoreographer* to, AChoreographer_frameCallback callback, void* data) {
    if (to != choreographer.get()) return reportMisuse("a thread uses the choreographer of another one");
    to->callbacks.emplace_back(callback, data);
    const std::int64_t timeNs = (nowNs() / refreshNs + 1) * refreshNs;
    itimerspec timer{};
    timer.it_value.tv_sec = static_cast<time_t>(timeNs / 1'000'000'000);
    timer.it_value.tv_nsec = static_cast<long>(timeNs % 1'000'000'000);
    timerfd_settime(to->fd, TFD_TIMER_ABSTIME, &timer, nullptr);
}

void AInputQueue_attachLooper(AInputQueue* queue, ALooper* to, int ident, ALooper_callbackFunc callback,
                              void* data) {
    queue->looper = to;
    ALooper_addFd(to, queue->fd, ident, ALOOPER_EVENT_INPUT, callback, data);
}

void AInputQueue_detachLooper(AInputQueue* queue) {
    if (queue->looper != nullptr) removeSource(*queue->looper, queue->fd);
    queue->looper = nullptr;
}

int32_t AInputQueue_getEvent(AInputQueue* queue, AInputEvent** event) {
    const std::lock_guard lock(queue->mutex);
    if (queue->events.empty()) return -EAGAIN;
    take(queue->fd);
    *event = queue->events.front();
    queue->events.pop_front();
    return 0;
}

int32_t AInputQueue_preDispatchEvent(AInputQueue*, AInputEvent*) {
    return 0;
}

void AInputQueue_finishEvent(AInputQueue*, AInputEvent* event, int) {
    delete event;
    ++state().eventsFinished;
}

int32_t AInputEvent_getType(const AInputEvent* event) {
    return event->type;
}
int32_t AMotionEvent_getAction(const AInputEvent* event) {
    return event->action;
}
int64_t AMotionEvent_getEventTime(const AInputEvent* event) {
    return event->timeNs;
}
size_t AMotionEvent_getPointerCount(const AInputEvent* event) {
    return event->points.size();
}
int32_t AMotionEvent_getPointerId(const AInputEvent* event, size_t index) {
    return event->points.at(index).id;
}
float AMotionEvent_getX(const AInputEvent* event, size_t index) {
    return event->points.at(index).x;
}
float AMotionEvent_getY(const AInputEvent* event, size_t index) {
    return event->points.at(index).y;
}

}  // extern "C"
