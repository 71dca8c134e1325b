// The strip above the map, shared by several controllers: the highest-ranked notice is shown.
#pragma once

#include <functional>
#include <map>

#include <QObject>
#include <QSet>
#include <QString>

#include "ui/kit/status_text.h"

namespace mapwright::ui {

class NoticeBar;

/// Their order.
enum class NoticeRank { Link, Draft, Map, Replay, Regions, Limits };

struct Notice {
  Mark mark = Mark::Neutral;
  QString sentence;  // plain text; empty = nothing to say
  QString offer = {};
  std::function<void()> accept = {};  // the offer
  bool closable = false;              // once closed, the same sentence is not shown again
};

class Notices : public QObject {
  Q_OBJECT
 public:
  /// `bar` must outlive this.
  explicit Notices(NoticeBar* bar, QObject* parent = nullptr);
  void set(NoticeRank rank, Notice notice);
  void clear(NoticeRank rank) { set(rank, {}); }

 private:
  const Notice* first() const;
  void show();

  NoticeBar* bar_;
  std::map<NoticeRank, Notice> wanted_;
  QSet<QString> dismissed_;
};

}  // namespace mapwright::ui
