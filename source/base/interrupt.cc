#include <stiction/base/interrupt.h>

#include <csignal>
#include <unistd.h>

namespace stiction
{
  namespace
  {
    // The handler's: what it may read and write.
    volatile std::sig_atomic_t interrupt_noted   = 0;
    volatile std::sig_atomic_t has_iterate       = 0;
    volatile std::sig_atomic_t interrupt_status  = 0;
    volatile std::sig_atomic_t interrupt_speaker = 0;

    constexpr int interrupting_signals[] = {SIGINT, SIGTERM, SIGUSR1};

    void note_interrupt(int)
    {
      if (has_iterate != 0)
        {
          interrupt_noted = 1;
          for (const int signal : interrupting_signals)
            std::signal(signal, SIG_DFL); // the next one ends the process
          return;
        }
      constexpr char sentence[] =
        "stiction: interrupted before there was any result, nothing was "
        "written.\n";
      if (interrupt_speaker != 0 &&
          write(STDERR_FILENO, sentence, sizeof(sentence) - 1) < 0)
        _exit(interrupt_status); // nobody listens
      _exit(interrupt_status);
    }
  } // namespace

  void watch_for_interrupts(const bool speaks, const int exit_status)
  {
    interrupt_speaker       = speaks ? 1 : 0;
    interrupt_status        = exit_status;
    struct sigaction action = {};
    action.sa_handler       = note_interrupt;
    action.sa_flags         = SA_RESTART;
    sigemptyset(&action.sa_mask);
    for (const int signal : interrupting_signals)
      sigaction(signal, &action, nullptr);
  }

  void keep_iterate_when_interrupted() { has_iterate = 1; }

  void ignore_interrupts()
  {
    for (const int signal : interrupting_signals)
      std::signal(signal, SIG_IGN);
  }

  bool is_interrupted(MPI_Comm communicator)
  {
    int noted = interrupt_noted;
    MPI_Allreduce(MPI_IN_PLACE, &noted, 1, MPI_INT, MPI_MAX, communicator);
    return noted != 0;
  }

  void stop_if_interrupted(MPI_Comm communicator)
  {
    if (is_interrupted(communicator))
      throw Interrupted();
  }
} // namespace stiction
