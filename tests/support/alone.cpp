// alone COMMAND ARGUMENT...: runs a test that is no GoogleTest in the environment of own_environment.cpp.
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>

int main(int, char** arguments) {
  pid_t child = 0;
  if (arguments[1] == nullptr ||
      posix_spawnp(&child, arguments[1], nullptr, nullptr, arguments + 1, environ) != 0) {
    std::perror("alone");
    return 127;
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}
