#include <stiction/base/blas_choice.h>

#include <algorithm>
#include <cstdlib>
#include <dlfcn.h>
#include <fstream>
#include <unistd.h>
#include <vector>

namespace stiction
{
  namespace
  {
    constexpr const char *core_variable  = "OPENBLAS_CORETYPE";
    constexpr const char *guard_variable = "STICTION_OPENBLAS_CORE_WAS";

    // What OpenBLAS calls the processor; empty for another library.
    std::string openblas_core()
    {
      using Name = const char *();
      auto *const name =
        reinterpret_cast<Name *>(dlsym(RTLD_DEFAULT, "openblas_get_corename"));
      return name != nullptr ? name() : "";
    }

    // Of OpenBLAS' names those whose kernels do without AVX2.
    bool knows_no_avx2(const std::string &core)
    {
      static const std::vector<std::string> names = {
        "katmai",      "coppermine", "northwood",  "prescott",     "banias",
        "atom",        "core2",      "penryn",     "dunnington",   "nehalem",
        "sandybridge", "athlon",     "opteron",    "opteron_sse3", "barcelona",
        "bobcat",      "bulldozer",  "piledriver", "steamroller",  "nano"};
      std::string lower = core;
      std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) {
        return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
      });
      return std::find(names.begin(), names.end(), lower) != names.end();
    }

    // The best kernels that the processor can run; empty if that is not known
    // to be any with AVX2.
    std::string best_core()
    {
#if defined(__x86_64__) && defined(__GNUC__)
      __builtin_cpu_init();
      if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma"))
        return {};
      if (__builtin_cpu_is("amd"))
        return "Zen";
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
                 __builtin_cpu_supports("avx512bw") &&
                 __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")
               ? "SkylakeX"
               : "Haswell";
#else
      return {};
#endif
    }

    std::vector<std::string> command_line()
    {
      std::ifstream file("/proc/self/cmdline");
      std::vector<std::string> words;
      for (std::string word; std::getline(file, word, '\0');)
        words.push_back(word);
      return words;
    }
  } // namespace

  void choose_blas_kernels()
  {
    if (std::getenv(core_variable) != nullptr || std::getenv(guard_variable) != nullptr)
      return;
    const std::string core = openblas_core(), better = best_core();
    if (better.empty() || !knows_no_avx2(core))
      return;

    std::vector<std::string> words = command_line();
    std::vector<char *> arguments;
    for (std::string &word : words)
      arguments.push_back(word.data());
    arguments.push_back(nullptr);
    setenv(core_variable, better.c_str(), 1);
    setenv(guard_variable, core.c_str(), 1);
    execv("/proc/self/exe", arguments.data());
    // still here: as if nothing had been tried
    unsetenv(core_variable);
    unsetenv(guard_variable);
  }

  std::string blas_remark()
  {
    const char *const before = std::getenv(guard_variable);
    const char *const now    = std::getenv(core_variable);
    if (before == nullptr || now == nullptr)
      return {};
    return std::string("OpenBLAS took this processor for '") + before +
           "': started again with " + core_variable + "=" + now + ".";
  }
} // namespace stiction
