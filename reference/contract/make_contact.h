/// @file How a contact is made: the two implementations behind the same contract.
#pragma once

#include <memory>

#include "contact_method.h"

namespace type21 {

namespace reference {
/// The reference: the formulation as written, one node after the other. Link with type21::reference.
/// @param interface  index into Scene::model->interfaces
/// @param scene      the contact keeps a copy, which shares the model; resolved, with one list of effects an interface.
///                   Values and indices of the model are not checked
/// @throws std::out_of_range when there is no such interface, with its number and how many there are
std::unique_ptr<ContactMethod> make_contact(const Scene& scene, int interface);
}  // namespace reference

namespace optimized {
/// The optimized implementation: the same decisions, forces to a few units in the last place. Link with
/// type21::optimized.
/// @param interface  index into Scene::model->interfaces
/// @param scene      the contact keeps a copy, which shares the model; resolved, with one list of effects an interface.
///                   Values and indices of the model are not checked
/// @throws std::out_of_range when there is no such interface, with its number and how many there are
std::unique_ptr<ContactMethod> make_contact(const Scene& scene, int interface);
}  // namespace optimized

}  // namespace type21
