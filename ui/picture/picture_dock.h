// The dock "Edit map": tools, what to paint, clean-up, and how much has changed.
#pragma once

#include <array>
#include <optional>

#include <QDockWidget>

#include "ui/picture/picture_tool.h"

class QLabel;
class QPushButton;
class QSpinBox;
class QToolButton;
class QVBoxLayout;

namespace mapwright::ui {

class PictureDock : public QDockWidget {
  Q_OBJECT
 public:
  /// Both must outlive this.
  PictureDock(edit::PictureEditing* editing, PictureTool* tool, QWidget* parent = nullptr);

  /// Why nothing can be edited; empty = it can.
  void setUnavailableReason(const QString& sentence);
  /// The progress or problem of saving; empty = none.
  void setSaving(bool saving, const QString& trouble);
  /// The share of the upload done, 0 .. 1; nullopt = no upload, or unknown.
  void setTravelled(std::optional<double> part);
  /// Where it is stored: files with a map.yaml, or a robot.
  void setLocal(bool local);

  QToolButton* modeButton(PaintMode mode) const { return modes_[std::size_t(mode)]; }
  QToolButton* kindButton(picture::Kind kind) const { return kinds_[std::size_t(kind)]; }
  QSpinBox* sizeBox() const { return size_; }
  QSpinBox* tidySize(edit::Tidying what) const { return tidy_sizes_[std::size_t(what)]; }
  QPushButton* tidyButton(edit::Tidying what) const { return tidy_buttons_[std::size_t(what)]; }
  QPushButton* applyButton() const { return apply_; }
  QPushButton* useTheirsButton() const { return theirs_; }
  /// An earlier draft; empty = none.
  void setOffer(const QString& sentence);
  QPushButton* stopButton() const { return stop_; }
  QString status() const;
  /// The meaning of the preview's colours.
  QStringList legend() const;

 Q_SIGNALS:
  void draftWanted();
  void draftNotWanted();
  void modeWanted(mapwright::ui::PaintMode mode);
  void lookWanted(mapwright::edit::Tidying what, int cells);
  void saveWanted();
  /// The part that had the focus is gone: otherwise keys for the map would be typed into the next field.
  void mapWanted();
  void discardWanted();
  void compareWanted();
  void copiesWanted();
  void locateConflictWanted();
  void stopSavingWanted();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void showPart(QWidget& part, bool visible);
  void buildModes(QVBoxLayout* column);
  void buildKinds(QVBoxLayout* column);
  void buildTidying(QVBoxLayout* column);
  void buildOffer(QVBoxLayout* column);
  void buildDecision(QVBoxLayout* column);
  void buildEnd();
  void refresh();
  QString statusText() const;
  QString previewText() const;

  edit::PictureEditing* editing_;
  PictureTool* tool_;
  QString unavailable_reason_, trouble_;
  bool saving_ = false;
  QLabel* empty_;
  QWidget* body_;
  QWidget* end_ = nullptr;  // what saves and discards, below what scrolls
  std::array<QToolButton*, kPaintModes> modes_{};
  std::array<QToolButton*, picture::kKinds> kinds_{};
  QSpinBox* size_ = nullptr;
  QLabel* size_m_ = nullptr;
  std::array<QSpinBox*, 3> tidy_sizes_{};
  std::array<QPushButton*, 3> tidy_buttons_{};
  QLabel* tidy_where_ = nullptr;
  QLabel* found_ = nullptr;
  struct LegendRow {
    QWidget* row = nullptr;
    QLabel* text = nullptr;
  };
  std::array<LegendRow, picture::kKinds> legend_{};
  QPushButton* apply_ = nullptr;
  QWidget *preview_row_ = nullptr, *decision_ = nullptr;
  QLabel *conflict_ = nullptr, *offer_ = nullptr;
  QWidget* offer_box_ = nullptr;
  QPushButton *mine_ = nullptr, *theirs_ = nullptr;
  QLabel* status_ = nullptr;
  QPushButton *compare_ = nullptr, *copies_ = nullptr, *discard_ = nullptr, *save_ = nullptr,
              *stop_ = nullptr;
  std::optional<int> travelled_;  // percent
};

}  // namespace mapwright::ui
