// Preloaded into programs under ThreadSanitizer, and not instrumented itself: tells it in which order Qt,
// which is not instrumented either, does things. Without this nearly every queued call is reported as a race.
// Order comes from
//   - posting an event: before its delivery, or before it is deleted undelivered,
//   - letting go of a slot object: the last one deletes it,
//   - QSemaphore (also that of a blocking queued call), QThreadPool::start() and waitForDone(),
//   QThread::wait().
// Nothing is suppressed: what two threads do without one of these is reported (races.cpp proves it).
//
// QtCore is linked so that its own calls cannot be interposed. So the first instructions of these functions
// are replaced by a jump to here, and are run elsewhere when the function itself is wanted. That they may be
// moved (whole instructions, none relative to where it lies) was seen by eye, for the QtCore of Debian 12.
// Any other is refused.
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <dlfcn.h>
#include <functional>
#include <string_view>
#include <sys/mman.h>
#include <unistd.h>

#include <QtCore/QtCore>

extern "C" {
void __tsan_acquire(void* at) __attribute__((weak));
void __tsan_release(void* at) __attribute__((weak));
}

namespace {

constexpr const char* kKnownQt = "6.4.2";

/// What happened before release() happens before what follows acquire().
void acquire(void* at) {
  if (at != nullptr) __tsan_acquire(at);
}
void release(void* at) {
  if (at != nullptr) __tsan_release(at);
}

[[noreturn]] void refuse(const char* what) {
  std::fprintf(stderr,
               "tests/tsan/qt_order.cpp knows the QtCore %s of Debian 12 for x86-64, and this is Qt %s: %s. "
               "Without it ThreadSanitizer reports races that are none.\n",
               kKnownQt, qVersion(), what);
  _exit(99);
}

/// Memory for the instructions that were moved.
unsigned char* moved_to = nullptr;
constexpr std::size_t kMovedBytes = 4096, kEachBytes = 64;

void writeJump(unsigned char* at, const void* to) {
  constexpr unsigned char kJump[] = {0xFF, 0x25, 0, 0, 0, 0};  // jmp *0(%rip), and the address behind it
  std::memcpy(at, kJump, sizeof(kJump));
  std::memcpy(at + sizeof(kJump), &to, sizeof(to));
}

/// Has `symbol` jump to `ours`. `start`: its first instructions, as they are known. The result is the
/// function as it was.
template <typename Function>
Function redirect(const char* symbol, Function ours, std::string_view start) {
  auto* const from = static_cast<unsigned char*>(dlsym(RTLD_DEFAULT, symbol));
  if (from == nullptr || std::memcmp(from, start.data(), start.size()) != 0) refuse(symbol);
  unsigned char* const moved = moved_to;
  moved_to += kEachBytes;
  std::memcpy(moved, from, start.size());
  writeJump(moved + start.size(), from + start.size());
  const auto page = std::uintptr_t(sysconf(_SC_PAGESIZE));
  auto* const pages = reinterpret_cast<void*>(reinterpret_cast<std::uintptr_t>(from) & ~(page - 1));
  if (mprotect(pages, page * 2, PROT_READ | PROT_WRITE | PROT_EXEC) != 0)
    refuse("its code cannot be changed");
  writeJump(from, reinterpret_cast<const void*>(ours));
  mprotect(pages, page * 2, PROT_READ | PROT_EXEC);
  return reinterpret_cast<Function>(moved);
}
#define AS_KNOWN(bytes) std::string_view(bytes, sizeof(bytes) - 1)

void (*postEvent)(QObject*, QEvent*, int);
void onPostEvent(QObject* to, QEvent* event, int priority) {
  release(event);
  release(to);
  postEvent(to, event, priority);
}

/// Events that nobody delivered are deleted in here.
void (*removePostedEvents)(QObject*, int);
void onRemovePostedEvents(QObject* of, int type) {
  acquire(of);
  removePostedEvents(of, type);
}

bool (*notify)(QObject*, QEvent*);
bool onNotify(QObject* to, QEvent* event) {
  acquire(event);
  const bool done = notify(to, event);
  if (event->type() == QEvent::MetaCall) release(to);
  release(QThread::currentThread());
  return done;
}

void (*semaphoreAcquire)(QSemaphore*, int);
void onSemaphoreAcquire(QSemaphore* semaphore, int count) {
  semaphoreAcquire(semaphore, count);
  acquire(semaphore);
}

void (*semaphoreRelease)(QSemaphore*, int);
void onSemaphoreRelease(QSemaphore* semaphore, int count) {
  release(semaphore);
  semaphoreRelease(semaphore, count);
}

/// The deadline comes in two registers.
bool (*threadWait)(QThread*, std::uint64_t, std::uint64_t);
bool onThreadWait(QThread* thread, std::uint64_t deadline, std::uint64_t kind) {
  const bool ended = threadWait(thread, deadline, kind);
  acquire(thread);
  return ended;
}

struct PoolJob final : QRunnable {
  PoolJob(QThreadPool* of, std::function<void()> job) : pool(of), run_it(std::move(job)) {}
  void run() override {
    acquire(this);
    run_it();
    run_it = nullptr;
    release(pool);
  }
  QThreadPool* pool;
  std::function<void()> run_it;
};
void onPoolStart(QThreadPool* pool, std::function<void()> job, int priority) {
  auto* const started = new PoolJob(pool, std::move(job));
  release(started);
  pool->start(started, priority);
}

/// The function ends in a relative jump to this, so it cannot be moved.
bool (*poolWait)(void*, int);
bool onPoolWait(QThreadPool* pool, int timeout_ms) {
  const bool done = poolWait(reinterpret_cast<void**>(pool)[1], timeout_ms);
  acquire(pool);
  return done;
}

__attribute__((constructor)) void install() {
  if (__tsan_acquire == nullptr) return;  // a program that a test starts, without ThreadSanitizer
  if (std::strcmp(qVersion(), kKnownQt) != 0) refuse("another version");
  void* const memory =
      mmap(nullptr, kMovedBytes, PROT_READ | PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) refuse("there is no memory for its code");
  moved_to = static_cast<unsigned char*>(memory);
  postEvent = redirect(
      "_ZN16QCoreApplication9postEventEP7QObjectP6QEventi", &onPostEvent,
      AS_KNOWN("\x41\x55\x41\x54\x55\x48\x89\xf5\x53\x48\x83\xec\x58\x64\x48\x8b\x04\x25\x28\x00\x00\x00"));
  removePostedEvents =
      redirect("_ZN16QCoreApplication18removePostedEventsEP7QObjecti", &onRemovePostedEvents,
               AS_KNOWN("\x41\x57\x41\x56\x49\x89\xfe\x41\x55\x41\x54\x55\x53\x48\x81\xec\x88\x08\x00\x00"));
  notify = redirect("_ZN16QCoreApplication15notifyInternal2EP7QObjectP6QEvent", &onNotify,
                    AS_KNOWN("\x41\x56\x41\x55\x49\x89\xf5\x41\x54\x55\x48\x89\xfd\x53\x48\x83\xec\x30"));
  semaphoreAcquire =
      redirect("_ZN10QSemaphore7acquireEi", &onSemaphoreAcquire,
               AS_KNOWN("\x41\x54\x48\x89\xf2\x55\x48\xc1\xe2\x20\x53\x48\x89\xfb\x48\x83\xec\x40"));
  semaphoreRelease = redirect("_ZN10QSemaphore7releaseEi", &onSemaphoreRelease,
                              AS_KNOWN("\x49\xb8\xff\xff\xff\xff\xff\xff\xff\x7f\x89\xf0\x48\x89\xc6"));
  threadWait = redirect("_ZN7QThread4waitE14QDeadlineTimer", &onThreadWait,
                        AS_KNOWN("\x41\x55\x41\x54\x49\x89\xd4\xba\x01\x00\x00\x00\x55\x48\x89\xf5\x53"));
  poolWait =
      reinterpret_cast<decltype(poolWait)>(dlsym(RTLD_DEFAULT, "_ZN18QThreadPoolPrivate11waitForDoneEi"));
  if (poolWait == nullptr) refuse("QThreadPoolPrivate::waitForDone");
  redirect("_ZN11QThreadPool11waitForDoneEi", &onPoolWait, AS_KNOWN("\x48\x8b\x7f\x08\xe9\x27\xff\xff\xff"));
  redirect("_ZN11QThreadPool5startESt8functionIFvvEEi", &onPoolStart,
           AS_KNOWN("\x41\x54\x55\x53\x48\x83\xec\x30\x64\x48\x8b\x04\x25\x28\x00\x00\x00"));
}

}  // namespace

// A symbol that can be interposed. The sender may be the last to let go of the slot object, and Qt counts its
// references unseen.
bool QMetaObject::invokeMethodImpl(QObject* object, QtPrivate::QSlotObjectBase* slot, Qt::ConnectionType type,
                                   void* result) {
  using Function = bool (*)(QObject*, QtPrivate::QSlotObjectBase*, Qt::ConnectionType, void*);
  static const auto qts = reinterpret_cast<Function>(dlsym(
      RTLD_NEXT,
      "_ZN11QMetaObject16invokeMethodImplEP7QObjectPN9QtPrivate15QSlotObjectBaseEN2Qt14ConnectionTypeEPv"));
  if (__tsan_acquire == nullptr) return qts(object, slot, type, result);
  slot->ref();
  const bool done = qts(object, slot, type, result);
  // Its first member is the count: at 1 only we hold it, and what the receiver did with it is over.
  if (reinterpret_cast<QAtomicInt*>(slot)->loadAcquire() == 1) acquire(object);
  slot->destroyIfLastRef();
  return done;
}
