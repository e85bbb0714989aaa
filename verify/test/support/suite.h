#ifndef TETRACONE_VERIFY_TEST_SUPPORT_SUITE_H
#define TETRACONE_VERIFY_TEST_SUPPORT_SUITE_H

// This header includes Boost.Test, and the headers of the standard library that most suites use.

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#endif
