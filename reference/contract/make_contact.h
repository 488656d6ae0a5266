/// @file How a contact is made: the two implementations behind the same contract.
#pragma once

#include <memory>

#include "contact_method.h"

namespace type21 {

namespace reference {
/// The reference: the formulation as written, one node after the other. Link with type21::reference.
/// @param interface  index into Scene::model->interfaces
/// @throws std::out_of_range when there is no such interface
std::unique_ptr<ContactMethod> make_contact(const Scene& scene, int interface);
}  // namespace reference

namespace optimized {
/// The optimized implementation: the same decisions, forces to a few units in the last place. Link with
/// type21::optimized.
/// @param interface  index into Scene::model->interfaces
/// @throws std::out_of_range when there is no such interface
std::unique_ptr<ContactMethod> make_contact(const Scene& scene, int interface);
}  // namespace optimized

}  // namespace type21
