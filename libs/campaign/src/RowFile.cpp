#include <bslnav/campaign/RowFile.h>
#include <bslnav/config/Error.h>
#include <bslnav/evaluation/RunRecorder.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace bslnav {
namespace {

std::string contentsOf(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

RowFile::RowFile(const std::string& path) : path_(path) {
  std::string text = contentsOf(path);
  const std::string header = CampaignRow::csvHeader() + "\n";
  text.resize(text.rfind('\n') + 1);  // npos + 1 is 0
  if (text.empty()) text = header;
  if (text.compare(0, header.size(), header) != 0)
    throw Error(path, "is no results.csv of a campaign; expected another directory",
                Error::Kind::Run);
  rows_ = std::count(text.begin(), text.end(), '\n') - 1;
  writeFile(path, text);
  file_.open(path, std::ios::app);
}

void RowFile::append(const CampaignRow& row) {
  file_ << row.csv() << '\n' << std::flush;
  if (!file_) throw Error(path_, "cannot be written: is the disk full?", Error::Kind::Run);
  ++rows_;
}

std::vector<CampaignRow> readRows(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line) || line != CampaignRow::csvHeader())
    throw Error(path, "expected results.csv of a campaign", Error::Kind::Run);
  std::vector<CampaignRow> rows;
  while (std::getline(file, line))
    rows.push_back(CampaignRow::fromCsv(line, path + " row " + std::to_string(rows.size() + 1)));
  return rows;
}

std::string shardFile(const std::string& directory, long rank, long size) {
  if (size == 1) return directory + "/results.csv";
  return directory + "/results." + std::to_string(rank) + "-of-" + std::to_string(size) + ".csv";
}

void mergeShards(const std::string& directory, long size) {
  std::vector<std::ifstream> shards;
  std::string line, text = CampaignRow::csvHeader() + "\n";
  for (long rank = 0; rank < size; ++rank) {
    shards.emplace_back(shardFile(directory, rank, size));
    std::getline(shards.back(), line);  // the header
  }
  for (std::size_t i = 0; std::getline(shards[i % shards.size()], line); ++i) text += line + "\n";
  writeFile(directory + "/results.csv", text);
}

void keepPlan(const std::string& directory, const std::string& plan) {
  const std::string path = directory + "/plan.ini";
  if (!std::filesystem::exists(path)) return writeFile(path, plan);
  if (contentsOf(path) != plan)
    throw Error(path,
                "another campaign is in this directory; expected the same command, to go on "
                "with it, or another --out");
}

}  // namespace bslnav
