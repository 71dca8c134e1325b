// The versions of overlays that are kept on this computer (history/version_store.h): written and asked for
// on a thread beside the GUI, in the order in which it was wanted. GUI thread.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <QObject>

#include "history/version_store.h"
#include "work/workers.h"

namespace mapwright::ui {

class OverlayHistory : public QObject {
  Q_OBJECT
 public:
  /// `path`: of the file; empty: nothing is kept.
  OverlayHistory(std::string path, std::shared_ptr<work::Workers> workers, QObject* parent = nullptr);
  /// What is to be kept is kept first.
  ~OverlayHistory() override;

  bool keepsAny() const { return !path_.empty(); }
  void keep(history::MapName map, std::optional<int> version, history::Origin origin, std::string text,
            double now_s);
  /// Of all maps, the newest first.
  void list(std::function<void(tl::expected<std::vector<history::KeptVersion>, Fault>)> reply);
  /// Gives `work` the store on that thread; what it returns is done on the GUI thread.
  using Done = std::function<void()>;
  void ask(std::function<Done(tl::expected<history::VersionStore, Fault> store)> work);

  /// Why the newest version could not be kept; None = nothing is wrong.
  const Fault& trouble() const { return trouble_; }

 Q_SIGNALS:
  void kept();
  void troubleChanged();

 private:
  struct Queue;
  void post(std::function<void()> job);
  void setTrouble(const std::optional<Fault>& why);

  std::string path_;
  Fault trouble_;
  std::shared_ptr<Queue> queue_;
  work::Tasks share_;  // last
};

}  // namespace mapwright::ui
