#include "verify/relations/metamorphic_relations.h"

#include <cassert>

namespace tetracone::verify {

const std::vector<Relation>& relations()
{
  static const std::vector<Relation> all = [] {
    std::vector<Relation> relations = predicate_relations();
    const std::vector<Relation> of_objects = object_relations();
    relations.insert(relations.end(), of_objects.begin(), of_objects.end());
    return relations;
  }();
  return all;
}

Verdict check(const Relation& relation, const Object_case& c, kernel::Question question, Running_subject& subject,
              Random& random)
{
  assert(relation.level == Level::object);
  return relation.of_object(c, question, subject, random);
}

Verdict check(const Relation& relation, const Predicate_case& c, Predicate predicate, const Predicate_subject& subject,
              Random& random)
{
  assert(relation.level == Level::predicate);
  return relation.of_predicate(c, predicate, subject, random);
}

}  // namespace tetracone::verify
