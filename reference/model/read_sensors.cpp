#include <array>
#include <utility>

#include <fmt/format.h>

#include "reference/deck/text_file.h"
#include "reference/model/numbers.h"
#include "reference/model/reading.h"
#include "reference/model/resolve_interfaces.h"

namespace type21 {

namespace {

Sensor::Kind kind_of(const std::string& word) {
    using Kind = Sensor::Kind;
    constexpr std::array<std::pair<std::string_view, Kind>, 7> kinds{{{"TIME", Kind::time},
                                                                      {"AND", Kind::all},
                                                                      {"SENS", Kind::all},
                                                                      {"OR", Kind::any},
                                                                      {"NOT", Kind::none},
                                                                      {"DIST", Kind::distance},
                                                                      {"INTER", Kind::force}}};
    for (const auto& [name, kind] : kinds) {
        if (word == name) return kind;
    }
    return Kind::unsupported;
}

/// Reads one card after the other of those that something uses.
class SensorReader {
  public:
    SensorReader(Reading& reading, int index)
        : reading_(reading),
          index_(index),
          card_(*reading.sensor_cards[static_cast<size_t>(index)]),
          reader_(reading.reader(card_, 3)) {}

    void read() {
        Sensor& sensor = this->sensor();
        if (sensor.kind == Sensor::Kind::unsupported) {
            reader_.error(
                -1, "", "",
                fmt::format("this kind of sensor is not supported, and {} uses it", reading_.sensor_users.at(index_)),
                "Use TIME, SENS, AND, OR, NOT, DIST or INTER");
            return;
        }
        if (sensor.kind == Sensor::Kind::time) {
            reader_.need({"title", "Tdelay"});
            read_time();
        } else {
            reader_.need({"title", "what the sensor looks at"});
            read_others();
        }
        reader_.finish();
    }

  private:
    void read_others() {
        Sensor& sensor = this->sensor();
        // Old decks leave the line of Tdelay out.
        const size_t last = filled_lines();
        if (last >= 2) sensor.delay = not_negative(reader_.real(1, 1, 20, "Tdelay", dim::time), 1, "Tdelay");
        const size_t line = last >= 2 ? 2 : 1;
        warn_of_excess(reader_, line + 1);
        if (sensor.kind == Sensor::Kind::distance) return read_distance(line);
        if (sensor.kind == Sensor::Kind::force) return read_force(line);
        read_logic(line);
    }

    Sensor& sensor() { return reading_.model.sensors[static_cast<size_t>(index_)]; }

    /// The last data line behind the title that is not blank; 0 when there is none.
    size_t filled_lines() const {
        size_t last = 0;
        for (size_t line = 1; line < reader_.line_count(); ++line) {
            if (!reader_.blank(line, 1, 100)) last = line;
        }
        return last;
    }

    double not_negative(double value, size_t line, std::string_view field) {
        if (value >= 0) return value;
        reader_.error(static_cast<int>(line), field, quantity(reader_, value, dim::time), "a duration is not negative",
                      "Give 0 or a positive time");
        return 0;
    }

    void read_time() {
        Sensor& sensor = this->sensor();
        sensor.delay = reader_.real(1, 1, 20, "Tdelay", dim::time);
        const bool with_stop = reading_.model.version >= 2023;
        if (with_stop) {
            const double stop = reader_.real(2, 1, 20, "Tstop", dim::time);
            if (stop != 0) sensor.stop = stop;
        }
        warn_of_excess(reader_, with_stop ? 3 : 2);
    }

    /// SENS and NOT look at one sensor, AND and OR at two (more are taken, too).
    void read_logic(size_t line) {
        const bool one = sensor().kind == Sensor::Kind::none || card_.words[1] == "SENS";
        for (int i = 0; i < (one ? 1 : 10); ++i) {
            if (i >= 2 && reader_.blank(line, 1 + 10 * i, 10 + 10 * i)) continue;
            const std::string field = one ? "sens_ID" : fmt::format("sens_ID{}", i + 1);
            const int other = reading_.reference(reader_, line, 1 + 10 * i, 10 + 10 * i, field, reading_.sensors, true);
            if (other < 0) continue;
            sensor().of.push_back(other);
            reading_.sensor_users.emplace(other, name());
        }
    }

    int node(size_t line, int first, std::string_view field) {
        const Id id = reader_.integer(line, first, first + 9, field);
        const auto found = reading_.model.nodes.index.find(id);
        if (found != reading_.model.nodes.index.end()) return found->second;
        reader_.error(static_cast<int>(line), field, fmt::format("{}", id), "there is no node with this id",
                      "Add it to /NODE, or correct the id");
        return -1;
    }

    void read_distance(size_t line) {
        Sensor& sensor = this->sensor();
        sensor.node_a = node(line, 1, "node_ID1");
        sensor.node_b = node(line, 11, "node_ID2");
        read_limits(line, "Dmin", "Dmax", dim::length);
    }

    void read_force(size_t line) {
        Sensor& sensor = this->sensor();
        sensor.interface = reading_.reference(reader_, line, 1, 10, "int_ID", reading_.interfaces, true);
        const std::string word = upper(reader_.text(line, 11, 20));
        using Force = Sensor::Force;
        constexpr std::array<std::pair<std::string_view, Force>, 8> parts{{{"", Force::normal},
                                                                           {"N", Force::normal},
                                                                           {"NF", Force::normal},
                                                                           {"T", Force::tangential},
                                                                           {"TF", Force::tangential},
                                                                           {"X", Force::x},
                                                                           {"Y", Force::y},
                                                                           {"Z", Force::z}}};
        bool known = false;
        for (const auto& [text, part] : parts) {
            if (word != text) continue;
            sensor.part = part;
            known = true;
        }
        if (!known) {
            reader_.error(static_cast<int>(line), "Dir", word,
                          "the force is that in one of the directions NF (normal), TF (tangential), X, Y, Z",
                          "Write it in columns 11 to 20; blank is NF");
        }
        read_limits(line, "Fmin", "Fmax", dim::force);
    }

    /// A limit that is blank or 0 does not act.
    void read_limits(size_t line, std::string_view low, std::string_view high, Dimension dimension) {
        Sensor& sensor = this->sensor();
        const double least = reader_.real(line, 21, 40, low, dimension);
        const double most = reader_.real(line, 41, 60, high, dimension);
        sensor.lasting = not_negative(reader_.real(line, 61, 80, "Tmin", dim::time), line, "Tmin");
        if (least != 0) sensor.low = least;
        if (most != 0) sensor.high = most;
        if (least == 0 && most == 0) {
            reader_.error(static_cast<int>(line), high, "0", fmt::format("{} or {} is given", low, high),
                          "Give the value from which on the sensor is on");
        } else if (sensor.low > sensor.high) {
            reader_.error(static_cast<int>(line), low, quantity(reader_, least, dimension),
                          fmt::format("{} is not above {}, {}", low, high, quantity(reader_, most, dimension)),
                          "The sensor is on outside of the two");
        }
    }

    std::string name() const { return card_.keyword; }

    Reading& reading_;
    int index_;
    const Card& card_;
    CardReader reader_;
};

/// Puts a sensor behind those that it looks at; one that looks at itself is an error.
class SensorOrder {
  public:
    explicit SensorOrder(Reading& reading) : reading_(reading), seen_(reading.model.sensors.size(), Seen::no) {}

    void add(int start) {
        // Depth first without recursion: a chain may be as long as the deck.
        std::vector<std::pair<int, size_t>> path{{start, 0}};
        while (!path.empty()) {
            auto& [index, next] = path.back();
            Seen& seen = seen_[static_cast<size_t>(index)];
            if (next == 0) {
                if (seen == Seen::yes) {
                    path.pop_back();
                    continue;
                }
                seen = Seen::on_path;
            }
            const std::vector<int>& of = reading_.model.sensors[static_cast<size_t>(index)].of;
            if (next == of.size()) {
                seen = Seen::yes;
                reading_.model.sensor_order.push_back(index);
                path.pop_back();
                continue;
            }
            const int child = of[next++];
            if (seen_[static_cast<size_t>(child)] == Seen::on_path) {
                report(child);
            } else {
                path.emplace_back(child, 0);
            }
        }
    }

  private:
    enum class Seen { no, on_path, yes };

    void report(int index) {
        CardReader reader = reading_.reader(*reading_.sensor_cards[static_cast<size_t>(index)], 3);
        reader.error(-1, "sens_ID", fmt::format("{}", reading_.model.sensors[static_cast<size_t>(index)].id),
                     "this sensor looks at itself, through the sensors that it names",
                     "Take one of the references out");
    }

    Reading& reading_;
    std::vector<Seen> seen_;
};

}  // namespace

/// The ids and kinds of /SENSOR. What a card says is read when it is known which of them something uses: one that
/// nothing uses does no harm.
void read_sensors(Reading& reading) {
    Model& model = reading.model;
    for (const ReadCard& entry : reading.cards) {
        if (entry.match.keyword != Keyword::sensor) continue;
        const Card& card = *entry.card;
        CardReader reader(reading.deck, card, model.units, model.units, reading.problems);
        const std::optional<Id> id = id_of(card, 2, reader);
        if (!id) continue;
        const auto index = static_cast<int>(model.sensors.size());
        const auto [known, is_new] =
            reading.sensors.entries.emplace(*id, Registry::Entry{index, reading.deck.place(card)});
        if (!is_new) {
            const Place& first = known->second.place;
            reader.error(-1, "id", fmt::format("{}", *id),
                         fmt::format("the id is taken by the card at {}:{}", first.file, first.line),
                         "Give each its own id, or remove one");
            continue;
        }
        Sensor sensor;
        sensor.id = *id;
        sensor.title = reader.text(0, 1, 100);
        sensor.kind = kind_of(card.words[1]);
        model.sensors.push_back(std::move(sensor));
        reading.sensor_cards.push_back(&card);
    }
}

int sensor_reference(Reading& reading, CardReader& reader, size_t line, int first) {
    const int index = reading.reference(reader, line, first, first + 9, "sens_ID", reading.sensors, false);
    if (index >= 0) reading.sensor_users.emplace(index, reader.keyword());
    return index;
}

/// Reads the sensors that something uses, with those that they look at, and puts them in order. Comes last: a sensor
/// may look at nodes and interfaces.
void link_sensors(Reading& reading) {
    Model& model = reading.model;
    for (const Interface& interface : model.interfaces) {
        if (interface.sensor >= 0)
            reading.sensor_users.emplace(interface.sensor, fmt::format("/INTER/TYPE21/{}", interface.id));
    }
    std::vector<int> used;
    std::vector<bool> met(model.sensors.size(), false);
    const auto use = [&](int index) {
        if (met[static_cast<size_t>(index)]) return;
        met[static_cast<size_t>(index)] = true;
        used.push_back(index);
    };
    for (int index = 0; index < static_cast<int>(model.sensors.size()); ++index) {
        if (reading.sensor_users.count(index) != 0) use(index);
    }
    SensorOrder order(reading);
    const size_t roots = used.size();
    for (size_t i = 0; i < used.size(); ++i) {
        SensorReader(reading, used[i]).read();
        for (const int other : model.sensors[static_cast<size_t>(used[i])].of)
            use(other);
    }
    for (size_t i = 0; i < roots; ++i)
        order.add(used[i]);
}

}  // namespace type21
