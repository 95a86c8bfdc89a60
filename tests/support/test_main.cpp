#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <cstdlib>

int main(int argc, char** argv) {
  // A property that fails must fail again the next time: one seed, unless somebody sets another.
  ::setenv("RC_PARAMS", "seed=1", 0);
  return doctest::Context(argc, argv).run();
}
