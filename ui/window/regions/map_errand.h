// What is fetched of a large map once: the whole, or a rectangle. One at a time; the questions go with it.
#pragma once

#include <functional>
#include <memory>

#include <QMessageBox>
#include <QObject>
#include <QPointer>

#include "regions/region_fetch.h"
#include "window/notices.h"
#include "window/window_context.h"

namespace mapwright::window {

class ExportJob;

class MapErrand : public QObject {
  Q_OBJECT
 public:
  explicit MapErrand(WindowContext& context, QObject* parent = nullptr);
  ~MapErrand() override;

  /// Whom to ask, and what is known of its map; both null: nobody. What is under way ends.
  void setDispatch(robot::MapDispatch* dispatch, const regions::RegionMap* map);

  bool busy() const { return fetch_ || whole_under_way_; }
  /// What is to be said of it; an empty sentence while nothing is fetched.
  Notice notice();
  QMessageBox* question() const { return question_; }  // null = none is asked

  /// Asks first, with the size that is known.
  void fetchWhole();
  /// Asks what is to become of it.
  void takeRectangle(const geometry::WorldRect& rect);
  /// Fetches the rectangle and writes `path`.pgm and .yaml, or shows it as a map.
  void saveRectangle(const geometry::WorldRect& rect, const QString& path);
  void keepRectangle(const geometry::WorldRect& rect);
  void stop();
  void closeQuestion();

 Q_SIGNALS:
  void changed();  // busy(), notice()

 private:
  enum class Then { Show, Save };
  void startWhole();
  void endWhole(const robot::Outcome<map::GridPart>& outcome);
  void startRectangle(const geometry::WorldRect& rect, Then then, const QString& path);
  void endRectangle();
  void show(std::function<std::string()> picture, const map::GridReference& grid, const QString& name);
  void save(const regions::FetchedGrid& fetched);
  void toast(Mark mark, const QString& text);

  WindowContext& context_;
  QPointer<robot::MapDispatch> dispatch_;
  QPointer<const regions::RegionMap> map_;
  QPointer<QMessageBox> question_;
  std::unique_ptr<regions::RegionFetch> fetch_;
  Then then_ = Then::Show;
  QString path_;
  robot::Call whole_;
  bool whole_under_way_ = false;
  std::uint64_t job_ = 0;  // what still comes of an older one is not taken
  std::unique_ptr<ExportJob> export_;
  work::Share share_;  // the last: it waits for what runs
};

}  // namespace mapwright::window
