// probe: tries, from where it is started, what footholdd's sandbox forbids and what footholdd needs. A line for each, "ok ..." or
// "HOLE ..."; exit code 1 if there is a hole. `probe hold PID` stops one thread of a process, its first, and nothing else of it.
#include <arpa/inet.h>
#include <fcntl.h>
#include <linux/capability.h>
#include <netinet/in.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/personality.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>

namespace {

int holes = 0;

void tell(bool good, const std::string& what) {
  std::printf("%s %s\n", good ? "ok  " : "HOLE", what.c_str());
  std::fflush(stdout);
  if (!good) ++holes;
}

// In a child, for what succeeds may not be undone.
template <class Attempt>
bool succeeds(const Attempt& attempt) {
  const pid_t child = fork();
  if (child == 0) _exit(attempt() ? 0 : 1);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

template <class Attempt>
void forbidden(const std::string& what, const Attempt& attempt) {
  tell(!succeeds(attempt), "cannot " + what);
}

template <class Attempt>
void needed(const std::string& what, const Attempt& attempt) {
  tell(succeeds(attempt), "can " + what);
}

bool writes(const std::string& path) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  if (file < 0) return false;
  unlink(path.c_str());
  return true;
}

// UDP, as DDS speaks.
bool sends_to(const char* address) {
  const int udp = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(7400);
  inet_pton(AF_INET, address, &to.sin_addr);
  return sendto(udp, "x", 1, 0, reinterpret_cast<const sockaddr*>(&to), sizeof(to)) == 1;
}

bool has_socket(int family, int type) { return socket(family, type, 0) >= 0; }

void try_files() {
  for (const char* folder : {"/usr/lib/foothold", "/etc/foothold", "/var/lib", "/boot", "/opt", "/root", "/home"})
    forbidden(std::string("write in ") + folder, [folder] { return writes(std::string(folder) + "/probe"); });
  forbidden("read root's home", [] { return access("/root/guest/lib.sh", R_OK) == 0; });
  forbidden("see the first process", [] { return access("/proc/1/status", R_OK) == 0; });
  forbidden("see the system's memory", [] { return access("/proc/meminfo", R_OK) == 0; });
  forbidden("change the kernel's settings", [] { return access("/proc/sys/kernel/core_pattern", W_OK) == 0; });
  forbidden("change control groups", [] { return mkdir("/sys/fs/cgroup/probe", 0700) == 0 && rmdir("/sys/fs/cgroup/probe") == 0; });
  forbidden("make a program that changes its user", [] {
    const std::string path = "/tmp/probe-suid";
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0700);
    const bool made = file >= 0 && fchmod(file, 04755) == 0;
    unlink(path.c_str());
    return made;
  });
  forbidden("make a device",
            [] { return mknod("/tmp/probe-device", S_IFCHR | 0600, 0x0103) == 0 && unlink("/tmp/probe-device") == 0; });
}

void try_kernel() {
  forbidden("make a user namespace", [] { return unshare(CLONE_NEWUSER) == 0; });
  forbidden("make a mount namespace", [] { return unshare(CLONE_NEWNS) == 0; });
  forbidden("mount", [] { return mount("none", "/tmp", "tmpfs", 0, nullptr) == 0; });
  forbidden("change the host's name", [] { return sethostname("probe", 5) == 0; });
  forbidden("set the clock", [] {
    const timespec never{0, -1};  // refused by whom it reaches, so that no clock is changed
    return syscall(SYS_clock_settime, CLOCK_REALTIME, &never) != 0 && errno != EPERM;
  });
  forbidden("map memory that is writable and executable", [] {
    return mmap(nullptr, 4096, PROT_READ | PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) != MAP_FAILED;
  });
  forbidden("run in real time", [] {
    const sched_param first{1};
    return sched_setscheduler(0, SCHED_FIFO, &first) == 0;
  });
  forbidden("change its personality", [] { return personality(ADDR_NO_RANDOMIZE) >= 0; });
  forbidden("keep a capability", [] { return prctl(PR_CAPBSET_READ, CAP_SYS_ADMIN, 0, 0, 0) == 1; });
  forbidden("read the kernel's log", [] { return syscall(SYS_syslog, 10, nullptr, 0) >= 0; });
}

void try_network() {
  forbidden("send past loopback", [] { return sends_to("10.99.0.1"); });
  forbidden("open a raw socket", [] { return has_socket(AF_PACKET, SOCK_RAW); });
  forbidden("open a vsock", [] { return has_socket(AF_VSOCK, SOCK_STREAM); });
}

void try_what_is_needed() {
  needed("send on loopback", [] { return sends_to("127.0.0.1"); });
  needed("list the interfaces (netlink)", [] { return has_socket(AF_NETLINK, SOCK_RAW); });
  needed("limit a worker's memory", [] {
    const rlimit limit{1ull << 32, 1ull << 32};
    return setrlimit(RLIMIT_AS, &limit) == 0;
  });
  needed("offer a worker to the kernel's out-of-memory killer", [] {
    const int file = open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);
    return file >= 0 && write(file, "500", 3) == 3;
  });
  needed("write its state", [] {
    const char* folder = std::getenv("STATE_DIRECTORY");
    return folder != nullptr && writes(std::string(folder) + "/probe");
  });
}

// Until the process is gone: then waitpid() has nothing more to wait for.
int hold(pid_t process) {
  if (ptrace(PTRACE_SEIZE, process, nullptr, nullptr) != 0 || ptrace(PTRACE_INTERRUPT, process, nullptr, nullptr) != 0) {
    std::perror("ptrace");
    return 1;
  }
  int status = 0;
  while (waitpid(process, &status, __WALL) > 0 && !WIFEXITED(status) && !WIFSIGNALED(status)) {
  }
  return 0;
}

}  // namespace

int main(int count, char** words) {
  if (count == 3 && std::strcmp(words[1], "hold") == 0) return hold(std::atoi(words[2]));
  try_files();
  try_kernel();
  try_network();
  try_what_is_needed();
  return holes == 0 ? 0 : 1;
}
