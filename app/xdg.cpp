#include "app/xdg.h"

#include <QByteArray>
#include <QByteArrayList>

namespace mapwright::app {

void ignoreRelativeFolders() {
  for (const char* name :
       {"XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_RUNTIME_DIR"}) {
    const QByteArray folder = qgetenv(name);
    if (!folder.isNull() && !folder.startsWith('/')) qunsetenv(name);
  }
  for (const char* name : {"XDG_CONFIG_DIRS", "XDG_DATA_DIRS"}) {
    const QByteArray folders = qgetenv(name);
    if (folders.isNull()) continue;
    QByteArrayList absolute;
    for (const QByteArray& folder : folders.split(':')) {
      if (folder.startsWith('/')) absolute << folder;
    }
    absolute.isEmpty() ? qunsetenv(name) : qputenv(name, absolute.join(':'));
  }
}

}  // namespace mapwright::app
