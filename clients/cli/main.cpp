// foothold: the command line of the planning server.
#include <cerrno>
#include <cstring>

#include "command_line.hpp"
#include "terminal.hpp"

int main(int count, char** words) {
  using namespace foothold::cli;
  Exit exit = Exit::kOther;
  try {
    exit = parse(count, words)();
  } catch (const Complaint& complaint) {
    print(complaint);
    exit = complaint.code();
  } catch (const std::exception& error) {
    print(Complaint(Exit::kOther, error.what()));
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    print(Complaint(Exit::kOther, std::string("the output could not be written: ") + std::strerror(errno)));
    return static_cast<int>(Exit::kOther);
  }
  return static_cast<int>(exit);
}
