#include "reference/deck/deck.h"

#include <utility>

namespace type21 {

namespace {

/// Which pieces of text some line points into.
class UsedTexts {
  public:
    explicit UsedTexts(const Deck& deck) : used_(deck.texts.size(), 0) {
        for (std::size_t i = 0; i < deck.texts.size(); ++i)
            begins_.emplace_back(deck.texts[i] ? deck.texts[i]->data() : nullptr, i);
        std::sort(begins_.begin(), begins_.end());
    }

    void mark(const DataLine& line) {
        const auto behind =
            std::upper_bound(begins_.begin(), begins_.end(), line.text().data(),
                             [](const char* text, const auto& begin) { return std::less<>()(text, begin.first); });
        if (behind != begins_.begin()) used_[(behind - 1)->second] = 1;
    }

    void mark(const std::vector<Card>& cards) {
        for (const Card& card : cards) {
            mark(card.place);
            for (const DataLine& line : card.lines)
                mark(line);
        }
    }

    bool is_used(std::size_t text) const { return used_[text] != 0; }

  private:
    std::vector<std::pair<const char*, std::size_t>> begins_;
    std::vector<char> used_;
};

}  // namespace

void forget_lines(Deck& deck, const std::function<bool(const Card&)>& of) {
    for (Card& card : deck.starter) {
        if (of(card)) card.lines = {};
    }
    UsedTexts used(deck);
    used.mark(deck.starter);
    used.mark(deck.engine);
    used.mark(deck.unread);
    for (std::size_t i = 0; i < deck.texts.size(); ++i) {
        if (!used.is_used(i)) deck.texts[i].reset();
    }
}

}  // namespace type21
