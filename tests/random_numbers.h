#pragma once

#include <cmath>
#include <random>
#include <vector>

// Random numbers that are the same everywhere; the distributions of the standard library
// are not.
class RandomNumbers
{
public:
  explicit RandomNumbers(const unsigned int seed)
    : engine_(seed)
  {
  }

  double uniform(const double a, const double b)
  {
    return a + (b - a) * (static_cast<double>(engine_()) + 0.5) / 4294967296.;
  }

  // Every order of magnitude between a and b > 0 is equally likely.
  double log_uniform(const double a, const double b)
  {
    return std::exp(uniform(std::log(a), std::log(b)));
  }

  // 0, ..., n − 1.
  unsigned int one_of(const unsigned int n) { return engine_() % n; }

  template<typename T = double> T pick(const std::vector<T> &values)
  {
    return values[one_of(static_cast<unsigned int>(values.size()))];
  }

private:
  std::mt19937 engine_;
};
