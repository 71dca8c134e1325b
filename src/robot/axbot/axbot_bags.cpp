#include "robot/axbot/axbot_bags.h"

#include <utility>

namespace mapwright::robot::axbot {

Call Bags::list(OutcomeTo<std::vector<BagEntry>> reply) {
  return wire::askAcross(
      line_.asker, line_.link, lists_, map::Subject(map::SubjectKind::Catalogue, map::kBagsPart),
      std::move(reply),
      [](AxbotLink& link, auto errand, auto answer) { link.bags().list(errand, std::move(answer)); });
}

Call Bags::info(const BagKey& key, OutcomeTo<BagInfo> reply) {
  return wire::askAcross(
      line_.asker, line_.link, infos_, subjectOf(key), std::move(reply),
      [key](AxbotLink& link, auto errand, auto answer) { link.bags().info(errand, key, std::move(answer)); });
}

Call Bags::messages(const BagKey& key, const BagRange& range, OutcomeTo<BagChunkPtr> reply) {
  return wire::askAcross(line_.asker, line_.link, chunks_, subjectOf(key), std::move(reply),
                         [key, range](AxbotLink& link, auto errand, auto answer) {
                           link.bags().messages(errand, key, range, std::move(answer));
                         });
}

Call Bags::picture(const std::string& topic, const std::string& url,
                   OutcomeTo<std::shared_ptr<const std::string>> reply) {
  return wire::askAcross(line_.asker, line_.link, pictures_, map::Subject(map::SubjectKind::Topic, topic),
                         std::move(reply), [topic, url](AxbotLink& link, auto errand, auto answer) {
                           link.bags().picture(errand, topic, url, std::move(answer));
                         });
}

Call Bags::record(const BagOrder& order, OutcomeTo<BagEntry> reply) {
  return wire::askAcross(
      line_.asker, line_.link, recordings_, map::Subject(map::SubjectKind::Catalogue, map::kRecordingsPart),
      std::move(reply),
      [order](AxbotLink& link, auto errand, auto answer) {
        link.bags().record(errand, order, std::move(answer));
      },
      wire::Stopping::AsItStands);
}

Call Bags::remove(const BagKey& key, OutcomeTo<BagKey> reply) {
  return wire::askAcross(
      line_.asker, line_.link, removals_, subjectOf(key), std::move(reply),
      [key](AxbotLink& link, auto errand, auto answer) {
        link.bags().remove(errand, key, std::move(answer));
      },
      wire::Stopping::AsItStands);
}

Call Bags::download(const BagKey& key, const QString& path, OutcomeTo<BagDownload> reply) {
  return wire::askAcross(line_.asker, line_.link, downloads_, subjectOf(key), std::move(reply),
                         [key, path](AxbotLink& link, auto errand, auto answer) {
                           link.bags().download(errand, key, path, std::move(answer));
                         });
}

}  // namespace mapwright::robot::axbot
