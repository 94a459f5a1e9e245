#include "app/command_line.h"
#include "core/base/this_process.h"

int main(int argc, char** argv) {
  return feedscope::run_command_line(feedscope::start_process(argc, argv));
}
