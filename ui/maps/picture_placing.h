// Finds the position of a picture: from the map.yaml in its folder, or by asking.
#pragma once

#include <functional>

#include <QObject>
#include <QPointer>
#include <QString>
#include <QStringList>

#include "work/workers.h"

class QWidget;

namespace mapwright::window {

class PictureDialog;

class PicturePlacing : public QObject {
  Q_OBJECT
 public:
  using Then = std::function<void(const QString& address)>;

  /// `yamls_naming`: returns the map.yaml files that name a picture as their image; accesses the disk, called
  /// on any thread. Null: always asks.
  PicturePlacing(QWidget* window, std::function<QStringList(const QString& picture)> yamls_naming,
                 std::shared_ptr<work::Workers> workers);

  /// Continues with the address of the map. Only the last request counts.
  void place(const QString& path, const QString& accept_text, const Then& then);
  PictureDialog* dialog() const;  // null: not open

 private:
  void ask(const QString& path, const QStringList& named_by, const QString& accept_text, const Then& then);

  QWidget* window_;
  std::function<QStringList(const QString& picture)> yamls_naming_;
  QPointer<PictureDialog> dialog_;
  quint64 asked_ = 0;
  work::Tasks share_;  // last member: waits for the look-up
};

}  // namespace mapwright::window
