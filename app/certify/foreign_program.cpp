#include "app/certify/foreign_program.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <netdb.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

#include "core/base/files/file.h"
#include "core/base/text.h"

namespace tactus::certify {
namespace {

namespace fs = std::filesystem;
using base::ErrorCode;
using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr std::size_t kLongestLine = std::size_t{1} << 20U;
constexpr std::size_t kMostSaid = 4096;
constexpr milliseconds kLook{50};     // between two looks at whether the user wants an end
constexpr milliseconds kEnding{200};  // for the status of a program that has closed its output

enum class Kind { kProgram, kLibrary, kNode, kTcp, kUnix };

Kind kindOf(std::string_view name) {
  if (name.starts_with("tcp:")) return Kind::kTcp;
  if (name.starts_with("unix:")) return Kind::kUnix;
  if (name.starts_with("node:")) return Kind::kNode;
  for (const std::string_view ending : {".so", ".dll", ".dylib"}) {
    if (name.ends_with(ending)) return Kind::kLibrary;
  }
  return Kind::kProgram;
}

/// `HOST:PORT`, the host perhaps in brackets.
std::pair<std::string, std::string> hostAndPort(std::string_view name) {
  const std::size_t colon = name.rfind(':');
  if (colon == std::string_view::npos) return {};
  std::string_view host = name.substr(0, colon);
  if (host.size() > 1 && host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
  return {std::string(host), std::string(name.substr(colon + 1))};
}

std::string reason(int number) { return std::generic_category().message(number); }

/// While one lives, writing to a program that is gone is an error and not the end of this one.
class NoBrokenPipe {
 public:
  NoBrokenPipe() {
    struct sigaction ignored {};
    ignored.sa_handler = SIG_IGN;
    sigaction(SIGPIPE, &ignored, &before_);
  }
  ~NoBrokenPipe() { sigaction(SIGPIPE, &before_, nullptr); }
  NoBrokenPipe(const NoBrokenPipe&) = delete;
  NoBrokenPipe& operator=(const NoBrokenPipe&) = delete;

 private:
  struct sigaction before_ {};
};

struct Pipe {
  base::Descriptor read_end;
  base::Descriptor write_end;
};

std::optional<Pipe> makePipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return std::nullopt;
  return Pipe{base::Descriptor(ends[0]), base::Descriptor(ends[1])};
}

void setNonBlocking(const base::Descriptor& descriptor) {
  fcntl(descriptor.number(), F_SETFL, fcntl(descriptor.number(), F_GETFL) | O_NONBLOCK);
}

/// The signals of the new process are as a shell would give them. It ends with this one.
void prepareChild() {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int number : {SIGPIPE, SIGINT, SIGTERM, SIGXFSZ}) std::signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

}  // namespace

std::string targetMistake(const std::string& name) {
  if (name.empty()) return "found an empty text";
  const Kind kind = kindOf(name);
  if (kind == Kind::kTcp) {
    const auto [host, port] = hostAndPort(std::string_view(name).substr(4));
    const auto number = base::parseInteger(port);
    if (host.empty() || !number || *number < 1 || *number > 65535)
      return "found " + base::quoted(name) + ", wanted tcp:HOST:PORT with a port from 1 to 65535";
  }
  if ((kind == Kind::kUnix || kind == Kind::kNode) && name.back() == ':')
    return "found " + base::quoted(name) + ", wanted a file behind the colon";
  return {};
}

ForeignProgram::ForeignProgram(ForeignProgram&& other) noexcept
    : patience_(std::move(other.patience_)),
      to_(std::move(other.to_)),
      from_(std::move(other.from_)),
      errors_(std::move(other.errors_)),
      child_(std::exchange(other.child_, 0)),
      folder_(std::move(other.folder_)),
      waiting_(std::move(other.waiting_)),
      said_(std::move(other.said_)) {}

ForeignProgram::~ForeignProgram() {
  to_.close();
  if (child_ > 0) {
    // Its end is waited for without being taken, so that its number still names it and what it started.
    const auto until = Clock::now() + patience_.answer;
    for (siginfo_t info{}; Clock::now() < until && !patience_.is_stopped();) {
      takeErrors();
      if (waitid(P_PID, static_cast<id_t>(child_), &info, WEXITED | WNOHANG | WNOWAIT) != 0 || info.si_pid != 0) break;
      poll(nullptr, 0, 1);
    }
    kill(-child_, SIGKILL);
    while (waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  std::error_code ignored;
  if (folder_.descriptor.isOpen()) fs::remove_all(folder_.path, ignored);
}

base::Result<ForeignProgram> ForeignProgram::open(const Target& target, Patience patience) {
  ForeignProgram program(std::move(patience));
  const auto run = [&](std::vector<std::string> words, const std::string& name) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    return program.start([&arguments] { execvp(arguments.front(), arguments.data()); }, name);
  };
  base::Result<void> opened;
  switch (kindOf(target.name)) {
    case Kind::kProgram: {
      std::vector<std::string> words = {target.name};
      words.insert(words.end(), target.arguments.begin(), target.arguments.end());
      opened = run(std::move(words), target.name);
      break;
    }
    case Kind::kLibrary:
      opened = program.start(
          [path = fs::absolute(target.name).string()] {
            // What the library prints is no answer.
            constexpr int kAnswers = STDERR_FILENO + 1;
            dup2(STDOUT_FILENO, kAnswers);
            dup2(STDERR_FILENO, STDOUT_FILENO);
            close_range(kAnswers + 1, ~0U, 0);
            answerWithLibrary(path, STDIN_FILENO, kAnswers);
            _exit(0);
          },
          target.name);
      break;
    case Kind::kNode: {
      std::error_code ignored;
      const fs::path place = fs::temp_directory_path(ignored) / "tactus-node";
      program.folder_ = base::makeUnfinishedFolder(place.string(), base::kUnfinishedEnding);
      if (!program.folder_.descriptor.isOpen())
        return base::fail(ErrorCode::kIo, place.string(), reason(errno), "a folder for temporary files");
      const std::string script = program.folder_.path + "/answer.mjs";
      if (const auto written = base::writeFileAtomically(script, nodeScript()); !written)
        return tl::unexpected(written.error());
      std::vector<std::string> words = {"node", script, fs::absolute(target.name.substr(5)).string()};
      words.insert(words.end(), target.arguments.begin(), target.arguments.end());
      opened = run(std::move(words), "node");
      break;
    }
    default: opened = program.connectTo(target);
  }
  if (!opened) return tl::unexpected(opened.error());
  for (const auto* one : {&program.to_, &program.from_, &program.errors_}) {
    if (one->isOpen()) setNonBlocking(*one);
  }
  return program;
}

base::Result<void> ForeignProgram::start(const std::function<void()>& body, const std::string& name) {
  auto in = makePipe();
  auto out = makePipe();
  auto err = makePipe();
  auto failed = makePipe();  // closes when the program runs
  if (!in || !out || !err || !failed) return base::fail(ErrorCode::kIo, name, reason(errno), "pipes to the program");
  child_ = fork();
  if (child_ < 0) {
    child_ = 0;
    return base::fail(ErrorCode::kIo, name, reason(errno), "a new process");
  }
  if (child_ == 0) {
    prepareChild();
    dup2(in->read_end.number(), STDIN_FILENO);
    dup2(out->write_end.number(), STDOUT_FILENO);
    dup2(err->write_end.number(), STDERR_FILENO);
    body();
    const int number = errno;
    [[maybe_unused]] const auto written = write(failed->write_end.number(), &number, sizeof number);
    _exit(127);
  }
  setpgid(child_, child_);
  in->read_end.close();
  out->write_end.close();
  err->write_end.close();
  failed->write_end.close();
  to_ = std::move(in->write_end);
  from_ = std::move(out->read_end);
  errors_ = std::move(err->read_end);
  int number = 0;
  ssize_t got = 0;
  while ((got = read(failed->read_end.number(), &number, sizeof number)) < 0 && errno == EINTR) {
  }
  if (got != sizeof number) return {};
  return base::fail(ErrorCode::kIo, name, number == ENOENT ? "no program of this name" : reason(number),
                    "a program that can be started" +
                        std::string(name.find('/') == std::string::npos ? ", in PATH or as ./" + name : ""));
}

base::Result<void> ForeignProgram::connectTo(const Target& target) {
  const auto failed = [&](std::string found) {
    return base::fail(ErrorCode::kIo, target.name, std::move(found), "a program that listens there");
  };
  if (kindOf(target.name) == Kind::kUnix) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string path = target.name.substr(5);
    if (path.size() >= sizeof address.sun_path) return failed("a name that is too long for a socket");
    std::copy(path.begin(), path.end(), address.sun_path);
    to_ = base::Descriptor(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
    if (connect(to_.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
      return failed(reason(errno));
  } else {
    const auto [host, port] = hostAndPort(std::string_view(target.name).substr(4));
    addrinfo wanted{};
    wanted.ai_socktype = SOCK_STREAM;
    addrinfo* all = nullptr;
    if (const int error = getaddrinfo(host.c_str(), port.c_str(), &wanted, &all); error != 0)
      return failed(gai_strerror(error));
    int number = 0;
    for (const addrinfo* one = all; one != nullptr; one = one->ai_next) {
      to_ = base::Descriptor(socket(one->ai_family, one->ai_socktype | SOCK_CLOEXEC | SOCK_NONBLOCK, one->ai_protocol));
      number = connect(to_.number(), one->ai_addr, one->ai_addrlen) == 0 ? 0 : errno;
      if (number == EINPROGRESS) {
        socklen_t size = sizeof number;
        const auto ready = wait(POLLOUT, Clock::now(), patience_.answer);
        if (!ready || getsockopt(to_.number(), SOL_SOCKET, SO_ERROR, &number, &size) != 0) number = ETIMEDOUT;
      }
      if (number == 0) break;
    }
    freeaddrinfo(all);
    if (number != 0) return failed(reason(number));
    const int at_once = 1;
    setsockopt(to_.number(), IPPROTO_TCP, TCP_NODELAY, &at_once, sizeof at_once);
  }
  from_ = base::Descriptor(fcntl(to_.number(), F_DUPFD_CLOEXEC, 0));
  return {};
}

base::Result<void> ForeignProgram::wait(short events, Clock::time_point start, milliseconds patience) {
  while (true) {
    if (patience_.is_stopped()) return base::fail(ErrorCode::kCancelled, {}, "a request to stop", "time to end");
    const auto left = std::chrono::ceil<milliseconds>(start + patience - Clock::now());
    if (left <= milliseconds(0)) {
      const std::string within = base::formatNumber(static_cast<double>(patience.count()) / 1000) + " s";
      return events == POLLIN ? base::fail(ErrorCode::kData, {}, "no answer within " + within, "one line")
                              : base::fail(ErrorCode::kIo, {}, "a program that does not read for " + within,
                                           "one that reads what it is asked");
    }
    std::array<pollfd, 2> looked{{{events == POLLIN ? from_.number() : to_.number(), events, 0},
                                  {errors_.isOpen() ? errors_.number() : -1, POLLIN, 0}}};
    poll(looked.data(), looked.size(), static_cast<int>(std::min(left, kLook).count()));
    if (looked[1].revents != 0) takeErrors();
    if (looked[0].revents != 0) return {};
  }
}

void ForeignProgram::takeErrors() {
  std::array<char, 4096> room;
  // A flood is read in turns.
  for (int turn = 0; turn < 16 && errors_.isOpen(); ++turn) {
    const ssize_t got = read(errors_.number(), room.data(), room.size());
    if (got < 0) return;
    if (got == 0) errors_.close();
    said_.append(room.data(), static_cast<std::size_t>(got));
    if (said_.size() > kMostSaid) said_.erase(0, said_.size() - kMostSaid);
  }
}

std::string ForeignProgram::lastWords() const {
  std::string_view last = said_;
  while (!last.empty() && (last.back() == '\n' || last.back() == '\r' || last.back() == ' ')) last.remove_suffix(1);
  last = last.substr(last.find_last_of("\r\n") + 1);
  return last.empty() ? std::string() : ", after the words " + base::quoted(last);
}

std::string ForeignProgram::ending() const {
  if (child_ <= 0) return "a connection that the program closed";
  siginfo_t info{};
  for (const auto until = Clock::now() + kEnding; Clock::now() < until && info.si_pid == 0; poll(nullptr, 0, 1))
    waitid(P_PID, static_cast<id_t>(child_), &info, WEXITED | WNOHANG | WNOWAIT);
  if (info.si_pid == 0) return "a program that closed its output" + lastWords();
  if (info.si_code == CLD_EXITED)
    return "a program that ended with status " + std::to_string(info.si_status) + lastWords();
  return std::string("a program that crashed (") + strsignal(info.si_status) + ")" + lastWords();
}

base::Result<void> ForeignProgram::send(std::string_view line) {
  const NoBrokenPipe quiet;
  const std::string bytes = std::string(line) + "\n";
  const auto start = Clock::now();
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t count = write(to_.number(), bytes.data() + sent, bytes.size() - sent);
    if (count >= 0) {
      sent += static_cast<std::size_t>(count);
    } else if (errno == EAGAIN) {
      if (const auto ready = wait(POLLOUT, start, patience_.answer); !ready) return ready;
    } else if (errno != EINTR) {
      return {};  // it is gone: what it said before can be received, then its end
    }
  }
  return {};
}

base::Result<std::string> ForeignProgram::receive(std::optional<milliseconds> patience) {
  const auto start = Clock::now();
  std::array<char, 65536> room;
  std::size_t searched = 0;
  while (true) {
    const std::size_t end = waiting_.find('\n', searched);
    if (end != std::string::npos) {
      std::string line = waiting_.substr(0, end);
      waiting_.erase(0, end + 1);
      if (!line.empty() && line.back() == '\r') line.pop_back();
      return line;
    }
    searched = waiting_.size();
    if (waiting_.size() > kLongestLine) {
      return base::fail(ErrorCode::kLimit, {}, "a line of more than 1 MiB", "one of at most 1 MiB");
    }
    if (const auto ready = wait(POLLIN, start, patience.value_or(patience_.answer)); !ready)
      return tl::unexpected(ready.error());
    const ssize_t got = read(from_.number(), room.data(), room.size());
    if (got > 0) {
      waiting_.append(room.data(), static_cast<std::size_t>(got));
    } else if (got == 0 || (errno != EAGAIN && errno != EINTR)) {
      takeErrors();
      return base::fail(ErrorCode::kIo, {}, ending(), "one that answers");
    }
  }
}

base::JsonWriter lineOf(std::string_view key) {
  base::JsonWriter json;
  json.beginObject(base::JsonWriter::Layout::kInline).key(key);
  return json;
}

}  // namespace tactus::certify
