// The bar above the map while two maps are compared: which ones, and how.
#pragma once

#include <variant>

#include <QFrame>
#include <QPointer>

#include "ui/scene/map_scene.h"

class QComboBox;
class QToolButton;

namespace mapwright::ui {

class PlainLabel;

/// What the second map of a comparison can be.
struct KeptState {
  bool operator==(const KeptState&) const = default;
};
struct SubmapsAside {  // the submaps against the whole map
  bool operator==(const SubmapsAside&) const = default;
};
struct FileAside {
  bool operator==(const FileAside&) const = default;
};
using SecondMap = std::variant<map::MapKey, KeptState, SubmapsAside, FileAside>;

class CompareBar : public QFrame {
  Q_OBJECT
 public:
  explicit CompareBar(QWidget* parent = nullptr);

  /// Fills the list of second maps and shows the state of both. `chosen`: the present second map.
  void sync(session::Session* session, scene::CompareMode mode, const std::optional<SecondMap>& chosen);

  QComboBox* second() const { return second_; }
  QToolButton* swipeButton() const { return swipe_; }
  QToolButton* differenceButton() const { return difference_; }
  QToolButton* closeButton() const { return close_; }
  QString firstShown() const;
  QString statusShown() const;
  bool legendShown() const { return !legend_->isHidden(); }

 Q_SIGNALS:
  void secondWanted(const mapwright::ui::SecondMap& second);
  void modeWanted(mapwright::ui::scene::CompareMode mode);
  void closed();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void fill(session::Session* session, const std::optional<SecondMap>& chosen);

  std::vector<SecondMap> offers_;  // by row of the list
  QStringList titles_;
  PlainLabel *first_, *status_;
  QComboBox* second_;
  QToolButton *swipe_, *difference_, *close_;
  QWidget* legend_;
};

}  // namespace mapwright::ui
