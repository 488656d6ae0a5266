/// @file Where the files of a deck lie: on the disk, or in memory.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/deck/deck.h"
#include "reference/deck/text_file.h"

namespace type21 {

/// What reading a deck asks of the place where its files lie.
class DeckFiles {
  public:
    virtual ~DeckFiles() = default;
    virtual bool exists(const std::string& path) const = 0;
    /// One name for a file, whatever path leads to it.
    virtual std::string identity(const std::string& path) const = 0;
    /// The name of a file in the same folder that differs in upper and lower case only; empty: none.
    virtual std::string similar(const std::string& path) const = 0;
    /// @param blame where the message points and which card asked for the file
    virtual std::optional<TextFile> load(const std::string& path, const Problem& blame, Problems& problems) const = 0;
};

class DiskFiles final : public DeckFiles {
  public:
    bool exists(const std::string& path) const override;
    std::string identity(const std::string& path) const override;
    std::string similar(const std::string& path) const override;
    std::optional<TextFile> load(const std::string& path, const Problem& blame, Problems& problems) const override;
};

/// Paths are compared after "a/../" and "./" are taken out.
class MemoryFiles final : public DeckFiles {
  public:
    /// @param files must outlive this
    explicit MemoryFiles(const std::vector<MemoryFile>& files) : files_(files) {}
    bool exists(const std::string& path) const override;
    std::string identity(const std::string& path) const override;
    std::string similar(const std::string& path) const override;
    std::optional<TextFile> load(const std::string& path, const Problem& blame, Problems& problems) const override;

  private:
    const MemoryFile* find(const std::string& path) const;
    const std::vector<MemoryFile>& files_;
};

}  // namespace type21
