#ifndef TETRACONE_VERIFY_TEST_SUPPORT_KERNEL_TEST_CASE_H
#define TETRACONE_VERIFY_TEST_SUPPORT_KERNEL_TEST_CASE_H

#include <boost/core/demangle.hpp>
#include <boost/test/unit_test.hpp>

#include <tuple>
#include <typeinfo>

namespace tetracone::verify {

/// Calls `test<K>()` for each kernel of a tuple; failures name the kernel.
template <class... Kernels, class Test>
void over_each(const std::tuple<Kernels...>*, const Test& test)
{
  const auto over = [&]<class K>() {
    BOOST_TEST_CONTEXT("over " << boost::core::demangle(typeid(K).name())) test.template operator()<K>();
  };
  (over.template operator()<Kernels>(), ...);
}

}  // namespace tetracone::verify

/// A test case whose body runs over each kernel K of a std::tuple. BOOST_AUTO_TEST_CASE_TEMPLATE, which makes each a
/// separate case, took a third of a unit's compilation.
#define KERNEL_TEST_CASE(test, K, Kernels)                                                                   \
  template <class K>                                                                                         \
  static void test##_over();                                                                                 \
  BOOST_AUTO_TEST_CASE(test)                                                                                 \
  {                                                                                                          \
    tetracone::verify::over_each(static_cast<const Kernels*>(nullptr), []<class K>() { test##_over<K>(); }); \
  }                                                                                                          \
  template <class K>                                                                                         \
  static void test##_over()

#endif
