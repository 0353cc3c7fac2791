#include "tests/support/real_time_trap.h"

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <semaphore.h>
#include <string_view>
#include <sys/ioctl.h>
#include <sys/types.h>
#include <typeinfo>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TACTUS_UNDER_SANITIZER 1
#else
#define TACTUS_UNDER_SANITIZER 0
#endif

namespace {

struct Watch {
  bool armed = false;
  int hits = 0;
  const char* first = "";
  long allocations = 0;
};
// In the executable and without a constructor: touching it never allocates, not even within malloc.
constinit thread_local Watch watch;

void note(const char* name) noexcept {
  if (!watch.armed) return;
  if (watch.hits++ == 0) watch.first = name;
}

void noteAllocation(const char* name) noexcept {
  ++watch.allocations;
  note(name);
}

}  // namespace

namespace tactus::support {

RealTimeTrap::RealTimeTrap() noexcept {
  watch.hits = 0;
  watch.first = "";
  watch.armed = true;
}

RealTimeTrap::~RealTimeTrap() { disarm(); }

void RealTimeTrap::disarm() noexcept {
  if (!watch.armed) return;
  watch.armed = false;
  hits_ = watch.hits;
  first_ = watch.first;
}

bool RealTimeTrap::catchesEverything() noexcept { return TACTUS_UNDER_SANITIZER == 0; }

long allocations() noexcept { return watch.allocations; }

}  // namespace tactus::support

// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming)
#if TACTUS_UNDER_SANITIZER

// The run-time libraries of the sanitizers call these at every allocation, operator new included.
extern "C" void __sanitizer_malloc_hook(const volatile void*, std::size_t) { noteAllocation("malloc"); }
extern "C" void __sanitizer_free_hook(const volatile void*) { note("free"); }

#else

// The C library's own names for its allocator: no look-up, which could itself allocate, is needed.
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);

void* malloc(std::size_t size) noexcept {
  noteAllocation("malloc");
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  noteAllocation("calloc");
  return __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size) noexcept {
  noteAllocation("realloc");
  return __libc_realloc(memory, size);
}
void* memalign(std::size_t alignment, std::size_t size) noexcept {
  noteAllocation("memalign");
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  noteAllocation("aligned_alloc");
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** out, std::size_t alignment, std::size_t size) noexcept {
  noteAllocation("posix_memalign");
  void* const memory = __libc_memalign(alignment, size);
  if (memory == nullptr) return ENOMEM;
  *out = memory;
  return 0;
}
void free(void* memory) noexcept {
  if (memory != nullptr) note("free");
  __libc_free(memory);
}
}

namespace {

/// Notes the call and gives the real function behind one of ours, looked up once. Condition variables have an old and
/// a new form, and a plain look-up may find the old one.
template <auto* Ours>
decltype(Ours) trapped(const char* name) noexcept {
  static constinit std::atomic<void*> known{nullptr};  // needs no guard, which could lock
  note(name);
  void* found = known.load(std::memory_order_acquire);
  if (found == nullptr) {
    if (std::string_view(name).starts_with("pthread_cond_")) found = dlvsym(RTLD_NEXT, name, "GLIBC_2.3.2");
    if (found == nullptr) found = dlsym(RTLD_NEXT, name);
    known.store(found, std::memory_order_release);
  }
  return reinterpret_cast<decltype(Ours)>(found);
}

}  // namespace

extern "C" {
int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  return trapped<&pthread_mutex_lock>("pthread_mutex_lock")(mutex);
}
int pthread_mutex_trylock(pthread_mutex_t* mutex) noexcept {
  return trapped<&pthread_mutex_trylock>("pthread_mutex_trylock")(mutex);
}
int pthread_rwlock_rdlock(pthread_rwlock_t* lock) noexcept {
  return trapped<&pthread_rwlock_rdlock>("pthread_rwlock_rdlock")(lock);
}
int pthread_rwlock_wrlock(pthread_rwlock_t* lock) noexcept {
  return trapped<&pthread_rwlock_wrlock>("pthread_rwlock_wrlock")(lock);
}
int pthread_spin_lock(pthread_spinlock_t* lock) noexcept {
  return trapped<&pthread_spin_lock>("pthread_spin_lock")(lock);
}
int pthread_cond_signal(pthread_cond_t* condition) noexcept {
  return trapped<&pthread_cond_signal>("pthread_cond_signal")(condition);
}
int pthread_cond_broadcast(pthread_cond_t* condition) noexcept {
  return trapped<&pthread_cond_broadcast>("pthread_cond_broadcast")(condition);
}
int pthread_cond_wait(pthread_cond_t* condition, pthread_mutex_t* mutex) {
  return trapped<&pthread_cond_wait>("pthread_cond_wait")(condition, mutex);
}
int pthread_cond_timedwait(pthread_cond_t* condition, pthread_mutex_t* mutex, const timespec* until) {
  return trapped<&pthread_cond_timedwait>("pthread_cond_timedwait")(condition, mutex, until);
}
int sem_wait(sem_t* semaphore) { return trapped<&sem_wait>("sem_wait")(semaphore); }
int sem_post(sem_t* semaphore) noexcept { return trapped<&sem_post>("sem_post")(semaphore); }
int nanosleep(const timespec* time, timespec* left) { return trapped<&nanosleep>("nanosleep")(time, left); }
int sched_yield() noexcept { return trapped<&sched_yield>("sched_yield")(); }

ssize_t read(int file, void* bytes, std::size_t size) { return trapped<&read>("read")(file, bytes, size); }
ssize_t write(int file, const void* bytes, std::size_t size) { return trapped<&write>("write")(file, bytes, size); }
int close(int file) { return trapped<&close>("close")(file); }
int poll(pollfd* files, nfds_t count, int timeout) { return trapped<&poll>("poll")(files, count, timeout); }
std::size_t fwrite(const void* bytes, std::size_t size, std::size_t count, FILE* file) {
  return trapped<&fwrite>("fwrite")(bytes, size, count, file);
}
int fputs(const char* text, FILE* file) { return trapped<&fputs>("fputs")(text, file); }
FILE* fopen(const char* path, const char* mode) { return trapped<&fopen>("fopen")(path, mode); }
int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;  // NOLINT(clang-analyzer-valist.Uninitialized)
  va_end(rest);
  return trapped<&open>("open")(path, flags, mode);
}
int ioctl(int file, unsigned long request, ...) noexcept {
  va_list rest;
  va_start(rest, request);
  void* const argument = va_arg(rest, void*);
  va_end(rest);
  return trapped<&ioctl>("ioctl")(file, request, argument);
}

[[noreturn]] void __cxa_throw(void* thrown, std::type_info* type, void (*destroy)(void*));
void __cxa_throw(void* thrown, std::type_info* type, void (*destroy)(void*)) {
  trapped<&__cxa_throw>("__cxa_throw")(thrown, type, destroy);
  __builtin_unreachable();
}
}

#endif
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)
