// Runs a program again and again without loading it each time, which for deal.II's two
// hundred libraries takes longer than most runs. Loaded before the program (LD_PRELOAD),
// it takes the place of the program's start and reads from the standard input, a line a
// run:
//
//   DIRECTORY<tab>ARGUMENT<tab>ARGUMENT...
//
// The program's main() runs in a copy of the process, in that directory, with its outputs
// in the files 'stdout' and 'stderr' there. A line of the standard output tells the exit
// status, or minus the signal that ended it; SIGXCPU if it used more than the processor
// time that FORK_SERVER_SECONDS gives, SIGALRM if it took ten times as long.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace
{
  using Main = int (*)(int, char **, char **);
  Main program;

  [[noreturn]] void run(const std::string &line, char **environment)
  {
    std::vector<std::string> arguments;
    std::istringstream words(line);
    for (std::string word; std::getline(words, word, '\t');)
      arguments.push_back(word);
    std::vector<char *> pointers;
    for (std::string &argument : arguments)
      pointers.push_back(argument.data());
    pointers.push_back(nullptr);

    if (chdir(arguments.at(0).c_str()) != 0)
      _exit(127);
    const int modes[]         = {O_RDONLY, O_WRONLY | O_CREAT | O_TRUNC,
                                 O_WRONLY | O_CREAT | O_TRUNC};
    const char *const files[] = {"/dev/null", "stdout", "stderr"};
    for (int descriptor = 0; descriptor < 3; ++descriptor)
      if (dup2(open(files[descriptor], modes[descriptor], 0666), descriptor) < 0)
        _exit(127);
    const unsigned int seconds = std::atoi(std::getenv("FORK_SERVER_SECONDS"));
    const rlimit limit         = {seconds, seconds + 5};
    setrlimit(RLIMIT_CPU, &limit);
    alarm(5 * seconds);
    std::exit(program(static_cast<int>(arguments.size()), pointers.data(), environment));
  }

  int serve(int, char **, char **environment)
  {
    unsetenv("LD_PRELOAD"); // what the program starts itself is started as ever
    for (std::string line; std::getline(std::cin, line);)
      {
        const pid_t child = fork();
        if (child == 0)
          run(line, environment);
        int status = 0;
        waitpid(child, &status, 0);
        std::cout << (WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status))
                  << std::endl;
      }
    return 0;
  }
} // namespace

// What the program's first instructions call, with its main().
extern "C" int __libc_start_main(Main main, int argc, char **argv, void (*init)(),
                                 void (*fini)(), void (*rtld_fini)(), void *stack_end)
{
  program     = main;
  using Start = int (*)(Main, int, char **, void (*)(), void (*)(), void (*)(), void *);
  const auto start = reinterpret_cast<Start>(dlsym(RTLD_NEXT, "__libc_start_main"));
  return start(serve, argc, argv, init, fini, rtld_fini, stack_end);
}
