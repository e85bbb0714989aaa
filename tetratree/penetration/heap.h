#ifndef TETRACONE_TETRATREE_PENETRATION_HEAP_H
#define TETRACONE_TETRATREE_PENETRATION_HEAP_H

#include <algorithm>
#include <utility>
#include <vector>

/// Heaps, which return their elements in an order. is_after(x, y) is a strict weak order: true where x comes after y.
/// The front of a heap comes first. All calls for one heap have the same order.
namespace tetracone::tetratree {

/// Adds an element to a heap.
template <class T, class Is_after>
void push_to(std::vector<T>& heap, T x, const Is_after& is_after)
{
  heap.push_back(std::move(x));
  std::ranges::push_heap(heap, is_after);
}

/// Takes the front out of a heap, and returns it. Requires a heap that is not empty.
template <class T, class Is_after>
T pop_from(std::vector<T>& heap, const Is_after& is_after)
{
  std::ranges::pop_heap(heap, is_after);
  T x = std::move(heap.back());
  heap.pop_back();
  return x;
}

}  // namespace tetracone::tetratree

#endif
