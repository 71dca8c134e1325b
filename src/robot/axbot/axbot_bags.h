// The bags of an Autoxing robot, on the thread of the robot. Source: docs/protocols/autoxing.md, "Bags".
#pragma once

#include "robot/axbot/axbot_capabilities.h"
#include "robot/bag_library.h"

namespace mapwright::robot::axbot {

class Bags : public BagLibrary {
 public:
  explicit Bags(Line line) : line_(line) {}
  Call list(OutcomeTo<std::vector<BagEntry>> reply) override;
  Call info(const BagKey& key, OutcomeTo<BagInfo> reply) override;
  Call messages(const BagKey& key, const BagRange& range, OutcomeTo<BagChunkPtr> reply) override;
  Call picture(const std::string& topic, const std::string& url,
               OutcomeTo<std::shared_ptr<const std::string>> reply) override;
  Call record(const BagOrder& order, OutcomeTo<BagEntry> reply) override;
  Call remove(const BagKey& key, OutcomeTo<BagKey> reply) override;
  Call download(const BagKey& key, const QString& path, OutcomeTo<BagDownload> reply) override;

 private:
  Line line_;
  wire::PendingCalls<std::vector<BagEntry>> lists_;
  wire::PendingCalls<BagInfo> infos_;
  wire::PendingCalls<BagChunkPtr> chunks_;
  wire::PendingCalls<std::shared_ptr<const std::string>> pictures_;
  wire::PendingCalls<BagEntry> recordings_;
  wire::PendingCalls<BagKey> removals_;
  wire::PendingCalls<BagDownload> downloads_;
};

}  // namespace mapwright::robot::axbot
