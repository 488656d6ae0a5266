/// @file Every TYPE21 card in turn: read, defaults, surfaces, checks.
#include "reference/model/resolve_interfaces.h"

namespace type21 {

void resolve_interfaces(const Deck& deck, Model& model, Problems& problems) {
    (void)deck;
    (void)model;
    (void)problems;
}

}  // namespace type21
