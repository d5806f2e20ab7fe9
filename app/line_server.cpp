// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "app/line_server.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <iterator>
#include <list>
#include <utility>
#include <vector>

namespace cad2slam::cli {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 18;

tl::unexpected<Error> systemError(ErrorCode code, const std::string& what, const std::string& where) {
  return fail(code, what + ": " + std::strerror(errno), where);
}

class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  [[nodiscard]] int get() const { return number_; }

 private:
  int number_;
};

/// Cuts a stream into lines and hands them on.
class LineStream {
 public:
  LineStream(const LineHandler& handler, const LineLimits& limits) : handler_(handler), limits_(limits) {}

  /// False when the line is too long; what was answered until then, and why it ends, is in `out`.
  [[nodiscard]] bool feed(std::string_view bytes, std::string& out) {
    while (!bytes.empty()) {
      const std::size_t end = bytes.find('\n');
      if (end == std::string_view::npos) {
        if (pending_.size() + bytes.size() > limits_.longest_line) return refuse(out);
        pending_.append(bytes);
        return true;
      }
      if (pending_.size() + end > limits_.longest_line) return refuse(out);
      if (pending_.empty()) {
        answer(bytes.substr(0, end), out);
      } else {
        pending_.append(bytes.substr(0, end));
        answer(pending_, out);
        pending_.clear();
      }
      bytes.remove_prefix(end + 1);
    }
    return true;
  }
  /// The last line may lack its end.
  void finish(std::string& out) {
    if (!pending_.empty()) answer(pending_, out);
    pending_.clear();
  }

 private:
  void answer(std::string_view line, std::string& out) {
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (!line.empty()) handler_(line, out);
  }
  bool refuse(std::string& out) {
    out += limits_.too_long;
    return false;
  }

  const LineHandler& handler_;
  const LineLimits& limits_;
  std::string pending_;
};

ssize_t readSome(int descriptor, std::vector<char>& buffer) {
  ssize_t count = 0;
  do {
    count = ::read(descriptor, buffer.data(), buffer.size());
  } while (count < 0 && errno == EINTR);
  return count;
}

bool writeAll(int descriptor, std::string& out) {
  std::size_t done = 0;
  while (done < out.size()) {
    const ssize_t count = ::write(descriptor, out.data() + done, out.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    done += static_cast<std::size_t>(count);
  }
  out.clear();
  return true;
}

int ending_writer = -1;  // what a signal handler may reach is global

extern "C" void onEnding(int /*signal*/) {
  const int kept = errno;
  static_cast<void>(!::write(ending_writer, "", 1));
  errno = kept;
}

/// Becomes readable at SIGINT or SIGTERM. Blocking the signals for a signalfd would not do: libraries have started
/// threads before main(), and these would take them.
Result<Descriptor> endingSignals() {
  int ends[2] = {-1, -1};
  if (::pipe2(ends, O_CLOEXEC | O_NONBLOCK) != 0) return systemError(ErrorCode::kInternal, "there is no pipe", "");
  ending_writer = ends[1];  // open until the process ends
  struct sigaction action {};
  action.sa_handler = onEnding;
  action.sa_flags = SA_RESTART;
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
  return Descriptor(ends[0]);
}

struct Connection {
  Connection(Descriptor connected, LineStream stream) : descriptor(std::move(connected)), lines(std::move(stream)) {}

  Descriptor descriptor;
  LineStream lines;
  std::string out;  // not yet sent, from `sent` on
  std::size_t sent = 0;
  bool closing = false;  // nothing more is read

  [[nodiscard]] std::size_t backlog() const { return out.size() - sent; }
};

class SocketServer {
 public:
  SocketServer(const LineHandler& handler, const LineLimits& limits, Descriptor listener, Descriptor signals)
      : handler_(handler),
        limits_(limits),
        listener_(std::move(listener)),
        signals_(std::move(signals)),
        buffer_(kChunk) {}

  void run() {
    while (true) {
      const bool accepts = std::exchange(accepts_, true);
      std::vector<pollfd> waiting = {{signals_.get(), POLLIN, 0},
                                     {listener_.get(), static_cast<short>(accepts ? POLLIN : 0), 0}};
      for (const Connection& connection : connections_)
        waiting.push_back({connection.descriptor.get(), static_cast<short>(wants(connection)), 0});
      if (::poll(waiting.data(), waiting.size(), accepts ? -1 : kPause_ms) < 0) {
        if (errno == EINTR) continue;
        return;
      }
      if (waiting[0].revents != 0) return;
      std::size_t k = 2;
      for (auto connection = connections_.begin(); connection != connections_.end(); ++k) {
        const bool alive = waiting[k].revents == 0 || serve(*connection, waiting[k].revents);
        connection = alive ? std::next(connection) : connections_.erase(connection);
      }
      if (waiting[1].revents != 0) acceptAll();
    }
  }

 private:
  [[nodiscard]] int wants(const Connection& connection) const {
    int events = 0;
    if (!connection.closing && connection.backlog() < limits_.largest_backlog) events |= POLLIN;
    if (connection.backlog() > 0) events |= POLLOUT;
    return events;
  }

  /// One read and one write: connections take turns. False when it is over.
  [[nodiscard]] bool serve(Connection& connection, int events) {
    if ((events & (POLLIN | POLLHUP | POLLERR)) != 0 && (wants(connection) & POLLIN) != 0) {
      const ssize_t count = readSome(connection.descriptor.get(), buffer_);
      if (count < 0 && errno != EAGAIN) return false;
      if (count == 0) {
        connection.lines.finish(connection.out);
        connection.closing = true;
      } else if (count > 0) {
        connection.closing = !connection.lines.feed({buffer_.data(), static_cast<std::size_t>(count)}, connection.out);
      }
    } else if ((events & POLLERR) != 0) {
      return false;
    }
    return send(connection) && !(connection.closing && connection.backlog() == 0);
  }

  [[nodiscard]] static bool send(Connection& connection) {
    if (connection.backlog() == 0) return true;
    const ssize_t count = ::send(connection.descriptor.get(), connection.out.data() + connection.sent,
                                 connection.backlog(), MSG_NOSIGNAL);
    if (count < 0) return errno == EAGAIN || errno == EINTR;
    connection.sent += static_cast<std::size_t>(count);
    if (connection.backlog() == 0) {
      connection.out.clear();
      connection.sent = 0;
    }
    return true;
  }

  /// Whoever comes when the house is full finds the door closed again.
  void acceptAll() {
    while (true) {
      Descriptor descriptor(::accept4(listener_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
      if (descriptor.get() < 0) {
        // Without a free descriptor the caller keeps waiting, and asking again at once would only heat the processor.
        accepts_ = errno == EAGAIN || errno == EINTR || errno == ECONNABORTED;
        return;
      }
      if (connections_.size() < limits_.most_connections) {
        connections_.emplace_back(std::move(descriptor), LineStream(handler_, limits_));
      }
    }
  }

  static constexpr int kPause_ms = 200;

  const LineHandler& handler_;
  const LineLimits& limits_;
  Descriptor listener_;
  Descriptor signals_;
  bool accepts_ = true;
  std::list<Connection> connections_;
  std::vector<char> buffer_;
};

Result<sockaddr_un> addressOf(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.empty() || path.size() >= sizeof address.sun_path) {
    return fail(ErrorCode::kOutOfDomain, "the path of a socket must have 1 to 107 bytes", path);
  }
  std::memcpy(address.sun_path, path.data(), path.size());
  return address;
}

/// Removes what a server that is gone has left behind, and nothing else.
Result<void> makeRoom(const std::string& path, const sockaddr_un& address) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0) return {};
  if (!S_ISSOCK(status.st_mode)) return fail(ErrorCode::kUnwritable, "a file that is no socket stands there", path);
  const Descriptor probe(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  if (::connect(probe.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) {
    return fail(ErrorCode::kUnwritable, "another server listens there", path);
  }
  if (errno == ECONNREFUSED) ::unlink(path.c_str());
  return {};
}

}  // namespace

Result<void> serveStandardInput(const LineHandler& handler, const LineLimits& limits) {
  std::signal(SIGPIPE, SIG_IGN);
  LineStream lines(handler, limits);
  std::vector<char> buffer(kChunk);
  std::string out;
  while (true) {
    const ssize_t count = readSome(STDIN_FILENO, buffer);
    if (count < 0) return systemError(ErrorCode::kUnreadable, "the input could not be read", "standard input");
    if (count == 0) lines.finish(out);
    const bool go_on = count > 0 && lines.feed({buffer.data(), static_cast<std::size_t>(count)}, out);
    if (!writeAll(STDOUT_FILENO, out)) {
      return systemError(ErrorCode::kUnwritable, "the output could not be written", "standard output");
    }
    if (count == 0) return {};
    if (!go_on) return fail(ErrorCode::kMalformed, "a line is too long", "standard input");
  }
}

Result<void> serveUnixSocket(const std::string& path, const LineHandler& handler, const LineLimits& limits,
                             const std::function<void()>& ready) {
  const Result<sockaddr_un> address = addressOf(path);
  if (!address) return failAs(address);
  if (Result<void> room = makeRoom(path, *address); !room) return room;
  Result<Descriptor> signals = endingSignals();
  if (!signals) return failAs(signals);
  Descriptor listener(::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  const mode_t mask = ::umask(0177);  // from its first moment only the owner may connect
  const int bound = ::bind(listener.get(), reinterpret_cast<const sockaddr*>(&*address), sizeof *address);
  const int reason = errno;
  ::umask(mask);
  errno = reason;
  if (bound != 0 || ::listen(listener.get(), SOMAXCONN) != 0) {
    return systemError(ErrorCode::kUnwritable, "the socket cannot be made", path);
  }
  ready();
  SocketServer(handler, limits, std::move(listener), std::move(*signals)).run();
  ::unlink(path.c_str());
  return {};
}

}  // namespace cad2slam::cli
