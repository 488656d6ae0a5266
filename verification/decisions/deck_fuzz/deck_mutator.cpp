#include "verification/decisions/deck_fuzz/deck_mutator.h"

#include <algorithm>
#include <array>
#include <random>
#include <string_view>
#include <vector>

namespace type21::fuzz {
namespace {

/// Numbers and words on which a reader may stumble: signs, borders of types, denormals, overflow, ids of the cases.
constexpr std::array<std::string_view, 40> words{"0",
                                                 "1",
                                                 "-1",
                                                 "2",
                                                 "3",
                                                 "101",
                                                 "900",
                                                 "4294967296",
                                                 "2147483647",
                                                 "-2147483648",
                                                 "9e9",
                                                 "0.0",
                                                 "-0.0",
                                                 "1e30",
                                                 "1e308",
                                                 "1e-308",
                                                 "5e-324",
                                                 "1e400",
                                                 "-1e400",
                                                 "nan",
                                                 "inf",
                                                 "1d3",
                                                 "1.0E+",
                                                 ".",
                                                 "-",
                                                 "+.5",
                                                 "1,5",
                                                 "0x10",
                                                 "999999999999999999999",
                                                 "kg",
                                                 "mm",
                                                 "/",
                                                 "#",
                                                 "X",
                                                 "ZZ",
                                                 "111",
                                                 "1e-30",
                                                 "1e15",
                                                 "-1e-200",
                                                 ""};

/// Keywords that a deck may have; one of them in place of another makes a card read by the wrong rules.
constexpr std::array<std::string_view, 34> keywords{"/BEGIN",         "/END",          "/NODE",
                                                    "/SHELL/1",       "/SH3N/1",       "/PART/1",
                                                    "/MAT/VOID/1",    "/MAT/LAW1/1",   "/MAT/PLAS_JOHNS/1",
                                                    "/HEAT/MAT/1",    "/PROP/SHELL/1", "/PROP/VOID/1",
                                                    "/SURF/PART/1",   "/SURF/SURF/1",  "/SURF/SEG/1",
                                                    "/GRNOD/NODE/1",  "/GRNOD/PART/1", "/GRNOD/GRNOD/1",
                                                    "/FUNCT/1",       "/BCS/1",        "/IMPVEL/1",
                                                    "/IMPDISP/1",     "/INIVEL/TRA/1", "/CLOAD/1",
                                                    "/ADMAS/0/1",     "/ADMAS/1/1",    "/RBODY/1",
                                                    "/SENSOR/TIME/1", "/FRICTION/1",   "/INTER/TYPE21/1",
                                                    "/TH/INTER/1",    "/INITEMP/1",    "/IMPTEMP/1",
                                                    "/UNIT/1"};

class Mutation {
  public:
    Mutation(std::string text, std::uint32_t seed) : random_(seed) {
        for (size_t at = 0; at < text.size();) {
            const size_t end = std::min(text.find('\n', at), text.size());
            lines_.push_back(text.substr(at, end - at));
            at = end + 1;
        }
        if (lines_.empty()) lines_.emplace_back();
    }

    std::string result() {
        const size_t changes = 1 + below(4);
        for (size_t i = 0; i < changes; ++i)
            change();
        std::string text;
        for (const std::string& line : lines_)
            text += line + "\n";
        return text;
    }

  private:
    size_t below(size_t end) { return random_() % end; }
    size_t line() { return below(lines_.size()); }

    void change() {
        switch (below(8)) {
            case 0:
                if (lines_.size() > 1) lines_.erase(at(line()));
                break;
            case 1:
                lines_.insert(at(line()), std::string(lines_[line()]));
                break;
            case 2:
                std::swap(lines_[line()], lines_[line()]);
                break;
            case 3:
                keyword();
                break;
            case 4: {  // a block of lines goes elsewhere: a card twice, a card inside another
                const size_t first = line();
                const size_t count = std::min(1 + below(20), lines_.size() - first);
                const std::vector<std::string> block(at(first), at(first + count));
                lines_.insert(at(line()), block.begin(), block.end());
                break;
            }
            default:
                field();
        }
    }

    void keyword() {
        std::vector<size_t> cards;
        for (size_t i = 0; i < lines_.size(); ++i)
            if (lines_[i].starts_with('/')) cards.push_back(i);
        if (cards.empty() || below(4) == 0) {
            lines_.insert(at(line()), std::string(keywords[below(keywords.size())]));
        } else {
            lines_[cards[below(cards.size())]] = keywords[below(keywords.size())];
        }
    }

    /// A word into a field of 10 or 20 columns, right-justified; or another field of the deck.
    void field() {
        const size_t width = below(2) == 0 ? 10 : 20;
        const size_t first = width * below(100 / width);
        std::string word(words[below(words.size())]);
        if (below(3) == 0) {
            const std::string& other = lines_[line()];
            const size_t from = std::min(width * below(100 / width), other.size());
            word = other.substr(from, width);
        }
        word.resize(std::min(word.size(), width));
        std::string& target = lines_[line()];
        if (target.size() < first + width) target.resize(first + width, ' ');
        target.replace(first, width, std::string(width - word.size(), ' ') + word);
    }

    std::vector<std::string>::iterator at(size_t i) { return lines_.begin() + static_cast<std::ptrdiff_t>(i); }

    std::vector<std::string> lines_;
    std::mt19937 random_;
};

}  // namespace

std::string mutated(std::string text, std::uint32_t seed) {
    return Mutation(std::move(text), seed).result();
}

}  // namespace type21::fuzz
