#include <array>
#include <utility>

#include <fmt/format.h>

#include "reference/deck/printable.h"
#include "reference/deck/text_file.h"
#include "reference/model/engine_keywords.h"
#include "reference/model/numbers.h"
#include "reference/model/reading.h"

namespace type21 {

namespace {

/// One card of the engine deck: numbers in free format, in the work units.
class EngineCard {
  public:
    EngineCard(Reading& reading, const Card& card) : reading_(reading), card_(card) {
        for (const DataLine& line : card.lines)
            split(line);
    }

    const std::string& word(size_t i) const {
        static const std::string none;
        return i < card_.words.size() ? card_.words[i] : none;
    }

    bool has(size_t i) const { return i < values_.size(); }

    /// False and an error when the card has no number at all: its data line is lost.
    bool need(std::string_view fields) {
        if (has(0)) return true;
        complain(Severity::error, nullptr, "", "no number",
                 fmt::format("the card ends early: it needs a data line ({})", fields), "Add the line");
        return false;
    }

    /// Number i of the card; 0 when it is not there.
    double number(size_t i, std::string_view field) {
        if (!has(i)) return 0;
        double value = 0;
        const auto& [text, line] = values_[i];
        if (parse_real(text, value) != NumberFault::none) {
            complain(Severity::error, &line, field, std::string(text), "this is not a number",
                     "Give numbers separated by blanks");
        }
        return value;
    }

    void complain(Severity severity, const DataLine* line, std::string_view field, std::string value, std::string rule,
                  std::string remedy) {
        Problem problem;
        problem.severity = severity;
        problem.place = line != nullptr ? reading_.deck.place(*line) : reading_.deck.place(card_);
        problem.card = card_.keyword;
        problem.field = std::string(field);
        problem.value = std::move(value);
        problem.rule = std::move(rule);
        problem.remedy = std::move(remedy);
        reading_.problems.add(std::move(problem));
    }

    void error(std::string_view field, double value, Dimension dimension, std::string rule, std::string remedy) {
        const std::string unit = reading_.model.units.name(dimension);
        complain(Severity::error, card_.lines.empty() ? nullptr : card_.lines.data(), field,
                 unit.empty() ? fmt::format("{}", value) : fmt::format("{} {}", value, unit), std::move(rule),
                 std::move(remedy));
    }

    /// A message that does not depend on the options of the keyword, so that /ANIM/VECT/VEL and /ANIM/DT count as one.
    void ignore(Severity severity, bool first_word_only, std::string rule, std::string remedy) {
        Problem problem;
        problem.severity = severity;
        problem.place = reading_.deck.place(card_);
        problem.card = first_word_only ? "/" + word(0) : keyword_without_ids(card_);
        problem.rule = std::move(rule);
        problem.remedy = std::move(remedy);
        reading_.problems.add(std::move(problem));
    }

  private:
    void split(const DataLine& line) {
        std::string_view rest = line.text();
        while (true) {
            const size_t first = rest.find_first_not_of(" ,");
            if (first == std::string_view::npos) return;
            rest.remove_prefix(first);
            const size_t end = std::min(rest.find_first_of(" ,"), rest.size());
            values_.emplace_back(rest.substr(0, end), line);
            rest.remove_prefix(end);
        }
    }

    Reading& reading_;
    const Card& card_;
    std::vector<std::pair<std::string_view, DataLine>> values_;
};

void read_run(EngineCard& card, Reading& reading) {
    EngineControl& engine = reading.model.engine;
    engine.run_name = printable(card.word(1));
    if (card.word(2) != "1" || !card.word(3).empty()) {
        card.complain(Severity::error, nullptr, "run number", card.word(2), "only the first run of a deck is supported",
                      "Write /RUN/NAME/1: a restart (2, 3, ...) is not read");
    }
    engine.end_time = card.number(0, "Tstop");
    if (!(engine.end_time > 0)) {
        card.error("Tstop", engine.end_time, dim::time, "the end time is positive", "Write it in the line behind /RUN");
    }
    if (upper(reading.model.run_name) != engine.run_name) {
        card.complain(Severity::warning, nullptr, "run name", engine.run_name,
                      fmt::format("the starter deck calls the run {}", reading.model.run_name),
                      "Use the same name in /BEGIN and /RUN");
    }
}

/// /DT/NODA[/CST or /STOP[/0]]: nodal time step with its scale factor and smallest value.
void read_step(EngineCard& card, EngineControl& engine) {
    const std::string& option = card.word(2);
    const bool known =
        card.word(1) == "NODA" && (option.empty() || option == "CST" || option == "STOP" || option == "0");
    const std::string flag = card.word(3);
    if (!known || !(flag.empty() || flag == "0")) {
        card.ignore(Severity::error, false, "this time step control is not supported",
                    "Use /DT/NODA, /DT/NODA/CST, /DT/NODA/STOP or /DTIX");
        return;
    }
    engine.nodal_step = true;
    if (!card.need("scale factor, Tmin")) return;
    const double factor = card.number(0, "scale factor");
    const double smallest = card.number(1, "Tmin");
    if (factor < 0 || factor > 1) {
        card.error("scale factor", factor, dim::none, "the scale factor of the time step is above 0 and at most 1",
                   "Give 0.9, or 0 for that default");
    } else if (factor > 0) {
        engine.step_scale = factor;
    }
    if (smallest < 0) {
        card.error("Tmin", smallest, dim::time, "a time step is not negative", "Give 0 for no limit");
    } else if (option == "CST" && smallest > 0) {
        card.error("Tmin", smallest, dim::time, "mass scaling to hold the time step is not supported",
                   "Give 0, or use /DT/NODA/STOP");
    } else {
        engine.smallest_step = smallest;
    }
}

/// /DTIX: the first and the largest time step.
void read_limits(EngineCard& card, EngineControl& engine) {
    const std::array<std::pair<std::string_view, std::optional<double>*>, 2> fields{
        {{"DTini", &engine.first_step}, {"DTmax", &engine.largest_step}}};
    if (!card.need("DTini, DTmax")) return;
    for (size_t i = 0; i < fields.size(); ++i) {
        const double value = card.number(i, fields[i].first);
        if (value < 0) {
            card.error(fields[i].first, value, dim::time, "a time step is not negative", "Give 0 for no limit");
        } else if (value > 0) {
            *fields[i].second = value;
        }
    }
}

void read_interval(EngineCard& card, EngineControl& engine) {
    if (!card.need("DTHIS")) return;
    const double interval = card.number(0, "DTHIS");
    if (interval < 0) {
        card.error("DTHIS", interval, dim::time, "an interval is not negative", "Give 0 for every cycle");
    } else {
        engine.history_interval = interval;
    }
}

/// /STOP: Emax ends a run whose energy grows; the limits of mass have nothing to judge, since no mass is added here.
void read_stop(EngineCard& card, EngineControl& engine) {
    const double energy = card.number(0, "Emax");
    if (energy < 0) {
        card.error("Emax", energy, dim::none, "a limit of energy is not negative", "Give 0 for the default");
    } else if (energy > 0) {
        engine.energy_limit = energy;
    }
    for (size_t i = 1; i < 3; ++i) {
        if (card.number(i, i == 1 ? "Mmax" : "Nmax") == 0) continue;
        card.ignore(Severity::warning, true, "the run is not stopped by limits of mass here: no mass is added",
                    "Nothing needs to be done");
        return;
    }
}

void read_card(Reading& reading, const Card& entry) {
    EngineCard card(reading, entry);
    EngineControl& engine = reading.model.engine;
    const std::string& word = card.word(0);
    if (word == "RUN") {
        read_run(card, reading);
    } else if (word == "DT") {
        read_step(card, engine);
    } else if (word == "DTIX") {
        read_limits(card, engine);
    } else if (word == "TFILE") {
        read_interval(card, engine);
    } else if (word == "STOP") {
        read_stop(card, engine);
    } else if (engine_keyword(word) == EngineKeyword::output) {
        reading.ignore(entry);
    } else if (engine_keyword(word) == EngineKeyword::unsupported) {
        card.ignore(Severity::error, false, "this keyword is not supported and may change the physics",
                    "Remove the card, or model the effect otherwise");
    }
}

}  // namespace

/// The engine deck: end time, time step and output interval, in the work units of the starter deck.
void read_engine(Reading& reading) {
    Problem problem;
    problem.place.file = reading.model.deck_path;
    problem.card = "/RUN";
    problem.field = "Tstop";
    if (!reading.deck.has_engine) {
        problem.severity = Severity::warning;
        problem.rule = "there is no engine deck beside the starter deck, so there is no end time";
        problem.remedy = "Put NAME_0001.rad beside NAME_0000.rad to run the deck";
        reading.problems.add(problem);
        return;
    }
    const Card* run = nullptr;
    for (const Card& card : reading.deck.engine) {
        if (!card.words.empty() && card.words[0] == "RUN") {
            if (run != nullptr) {
                EngineCard(reading, card)
                    .complain(Severity::error, nullptr, "", "",
                              fmt::format("an engine deck has one /RUN; the first is in line {}", run->place.number),
                              "Remove one");
                continue;
            }
            run = &card;
        }
        read_card(reading, card);
    }
    if (run == nullptr) {
        if (!reading.deck.engine.empty()) problem.place = {reading.deck.place(reading.deck.engine.front()).file, 0};
        problem.rule = "an engine deck has a /RUN card with the end time; there is none";
        problem.remedy = "Add /RUN/NAME/1 and the end time in the next line";
        reading.problems.add(problem);
    }
}

}  // namespace type21
