// What a document tells, whatever its items are.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <QObject>

namespace mapwright::edit {

/// Keys of items that came, that are other ones now or stand otherwise (saved, sent, …), and that went.
struct DocumentChange {
  std::vector<std::string> added, changed, removed;
  bool everything = false;  // look at all of it anew; the lists are empty
  /// Of `changed`: the fields that may be others now, one bit each as in Fields<Item>::all. How they stand
  /// may be another thing in any case.
  std::uint32_t fields = ~std::uint32_t(0);
};

class DocumentEvents : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  ~DocumentEvents() override;

 Q_SIGNALS:
  /// The one signal: items, their states, or those of the whole.
  void changed(const mapwright::edit::DocumentChange& change);
};

}  // namespace mapwright::edit
