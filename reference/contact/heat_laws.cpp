#include "reference/contact/heat_laws.h"

#include <algorithm>

namespace type21::reference {

double heat_reach(const Interface& interface) {
    if (interface.ithe == 0) return 0;
    const double radiation = interface.frad > 0 ? interface.drad.value : 0.0;
    const double conduction = interface.function_distance >= 0 ? interface.dcond.value : 0.0;
    return std::max(radiation, conduction);
}

HeatZones heat_zones(const Interface& interface, double distance, double gap) {
    HeatZones zones;
    zones.conduction = distance <= gap;
    if (zones.conduction) return zones;
    zones.distance = interface.function_distance >= 0 && distance <= interface.dcond;
    zones.radiation = interface.frad > 0 && distance <= interface.drad;
    return zones;
}

double conduction_abscissa(const Interface& interface, double pressure) {
    return pressure / interface.ascalek;
}

double conduction_conductance(double exchange, double distance, double conductivity) {
    if (exchange <= 0) return 0;
    if (distance <= 0) return exchange;
    if (conductivity <= 0) return 0;
    return 1.0 / (distance / conductivity + 1.0 / exchange);
}

double distance_conductance(double exchange, double share, double gap, double conductivity) {
    return conduction_conductance(exchange * share, gap, conductivity);
}

double radiated(double frad, double tool_temperature, double blank_temperature) {
    // (T_m^4 - T_s^4) without the cancellation of two large powers.
    return radiant_conductance(frad, tool_temperature, blank_temperature) * (tool_temperature - blank_temperature);
}

double radiant_conductance(double frad, double tool_temperature, double blank_temperature) {
    const double tool2 = tool_temperature * tool_temperature;
    const double blank2 = blank_temperature * blank_temperature;
    return frad * (tool2 + blank2) * (tool_temperature + blank_temperature);
}

}  // namespace type21::reference
