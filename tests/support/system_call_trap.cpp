#include "tests/support/system_call_trap.h"

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <iterator>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <thread>
#include <ucontext.h>

namespace tactus::support {

#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace {

constinit thread_local SystemCalls seen;

void onSystemCall(int, siginfo_t* info, void* context) {
  if (seen.count++ == 0) seen.first = info->si_syscall;
  static_cast<ucontext_t*>(context)->uc_mcontext.gregs[REG_RAX] = -ENOSYS;
}

/// For the rest of this thread's life. Permitted is only what ends a signal handler and the thread itself.
bool forbidSystemCalls() {
  constexpr auto kNumber = offsetof(seccomp_data, nr);
  sock_filter program[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, kNumber),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_rt_sigreturn, 4, 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_exit, 3, 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_rt_sigprocmask, 2, 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_madvise, 1, 0),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRAP),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const sock_fprog filter{static_cast<unsigned short>(std::size(program)), program};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

}  // namespace

std::optional<SystemCalls> systemCallsOf(const std::function<void()>& body) {
  struct sigaction action {};
  struct sigaction before {};
  action.sa_sigaction = onSystemCall;
  action.sa_flags = SA_SIGINFO;
  sigaction(SIGSYS, &action, &before);
  std::optional<SystemCalls> result;
  std::thread thread([&] {
    if (!forbidSystemCalls()) return;
    body();
    result = seen;
  });
  thread.join();
  sigaction(SIGSYS, &before, nullptr);
  return result;
}

#else

std::optional<SystemCalls> systemCallsOf(const std::function<void()>&) { return std::nullopt; }

#endif

}  // namespace tactus::support
