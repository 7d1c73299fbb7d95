// HexFeatureWB - LGPL-2.1-or-later
#include "tetsplit/child_process.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdlib>

extern char** environ;

namespace hexfeature {
namespace {

/// Closed, killed and waited for, whatever happens.
struct Child {
  pid_t pid = -1;
  int socket = -1;

  ~Child() {
    if (socket >= 0) close(socket);
    if (pid > 0) {
      kill(pid, SIGKILL);
      wait();
    }
  }
  /// Exit status; 0 also when somebody else has collected it.
  int wait() {
    int status = 0;
    while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
    }
    pid = -1;
    return status;
  }
};

bool start(const std::string& program, Child& child) {
  int ends[2];
  if (access(program.c_str(), X_OK) != 0 || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return false;
  child.socket = ends[0];
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], 1);
  posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
  // Ctrl-C in a terminal reaches the parent alone; it kills the child.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  char* const arguments[] = {const_cast<char*>(program.c_str()), nullptr};
  const int failed = posix_spawn(&child.pid, program.c_str(), &actions, &attributes, arguments, environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  if (failed != 0) child.pid = -1;
  return failed == 0;
}

}  // namespace

ChildResult run_child(const std::string& program, const std::vector<char>& input, Context& context) {
  constexpr int kPollMilliseconds = 50;
  ChildResult result;
  Child child;
  if (!start(program, child)) return result;
  result.started = true;
  std::size_t sent = 0;
  bool sending = true;
  std::vector<char> buffer(1 << 16);
  for (;;) {
    context.check_with_child(child.pid);
    pollfd wait{child.socket, static_cast<short>(POLLIN | (sending ? POLLOUT : 0)), 0};
    const int ready = poll(&wait, 1, kPollMilliseconds);
    if (ready < 0 && errno != EINTR) return result;
    if (ready <= 0) continue;
    if (sending && (wait.revents & POLLOUT)) {
      const ssize_t n = send(child.socket, input.data() + sent, input.size() - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
      if (n > 0) sent += static_cast<std::size_t>(n);
      if (sent == input.size() || (n < 0 && errno != EAGAIN && errno != EINTR)) {
        sending = false;
        shutdown(child.socket, SHUT_WR);
      }
    }
    if (wait.revents & (POLLIN | POLLHUP | POLLERR)) {
      const ssize_t n = recv(child.socket, buffer.data(), buffer.size(), MSG_DONTWAIT);
      if (n > 0) result.output.insert(result.output.end(), buffer.begin(), buffer.begin() + n);
      if (n == 0 || (n < 0 && errno != EAGAIN && errno != EINTR)) break;
    }
  }
  const int status = child.wait();
  result.ended_well = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  return result;
}

std::string program_beside_library(const std::string& name) {
  Dl_info info;
  if (dladdr(reinterpret_cast<const void*>(&run_child), &info) == 0 || info.dli_fname == nullptr) return name;
  char resolved[PATH_MAX];
  if (realpath(info.dli_fname, resolved) == nullptr) return name;
  const std::string path = resolved, folder = path.substr(0, path.find_last_of('/') + 1);
  // In the build tree the tests' executables lie two folders above the package.
  for (const char* package : {"", "python/hexfeature/"})
    if (access((folder + package + name).c_str(), X_OK) == 0) return folder + package + name;
  return folder + name;
}

}  // namespace hexfeature
