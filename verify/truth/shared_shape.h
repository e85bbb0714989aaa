#ifndef TETRACONE_VERIFY_TRUTH_SHARED_SHAPE_H
#define TETRACONE_VERIFY_TRUTH_SHARED_SHAPE_H

#include <CGAL/version.h>

// CGAL::intersection returns Boost's variant, and from CGAL 6 on the standard's.
#if CGAL_VERSION_NR < 1060000000
#include <boost/variant.hpp>
#else
#include <variant>
#endif

namespace tetracone::verify {

/// Returns the shape in a result of CGAL::intersection if it is a T, else null. Requires a result that is not empty.
template <class T, class Result>
const T* shape_in(const Result& result)
{
#if CGAL_VERSION_NR < 1060000000
  return boost::get<T>(&*result);
#else
  return std::get_if<T>(&*result);
#endif
}

/// Calls take(shape) for the shape in a result of CGAL::intersection. Requires a result that is not empty.
template <class Take, class Result>
void take_shape(const Take& take, const Result& result)
{
#if CGAL_VERSION_NR < 1060000000
  boost::apply_visitor(take, *result);
#else
  std::visit(take, *result);
#endif
}

}  // namespace tetracone::verify

#endif
