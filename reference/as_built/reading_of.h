/// @file The one place where the departures of the contact are put in.
#pragma once

#include "reference/contact/contact_reading.h"
#include "reference/contract/scene.h"

namespace type21::reference::as_built {

/// The reading of one interface: as documented, with the as-built law in place of each departure that is switched on in
/// ContactModel::as_built. Departures of the card and of the host are in reference/model/card_reading.h and
/// reference/host/host_reading.h.
/// @param interface  one of model.interfaces; the reading holds copies of what it needs of both
/// @return Formulation 12, step 1
ContactReading reading_of(const ContactModel& model, const Interface& interface);

}  // namespace type21::reference::as_built
