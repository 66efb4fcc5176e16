#include "record/file/memory_files.h"

#include <sqlite3.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <string_view>

namespace resect {
namespace {

constexpr const char* kName = "resect_memory";

RecordingBytes* gBytes = nullptr;  // what the VFS serves at present
std::size_t gMost = 0;             // bytes of each of the two that may be written

struct MemoryFile {
  sqlite3_file base;  // SQLite's part, first
  RawArray<char>* bytes;
};

RawArray<char>& bytesOf(sqlite3_file* file) { return *reinterpret_cast<MemoryFile*>(file)->bytes; }

int closeFile(sqlite3_file*) { return SQLITE_OK; }

int readFile(sqlite3_file* file, void* to, int size, sqlite3_int64 at) {
  const RawArray<char>& bytes = bytesOf(file);
  const auto wanted = std::size_t(size);
  const std::size_t begin = std::min(bytes.size(), std::size_t(std::max<sqlite3_int64>(at, 0)));
  const std::size_t there = std::min(wanted, bytes.size() - begin);
  if (there > 0) std::memcpy(to, bytes.data() + begin, there);
  if (there == wanted) return SQLITE_OK;
  std::memset(static_cast<char*>(to) + there, 0, wanted - there);
  return SQLITE_IOERR_SHORT_READ;
}

int writeFile(sqlite3_file* file, const void* from, int size, sqlite3_int64 at) {
  RawArray<char>& bytes = bytesOf(file);
  if (size <= 0) return SQLITE_OK;
  if (at < 0 || std::size_t(at) > gMost) return SQLITE_FULL;
  const std::size_t end = std::size_t(at) + std::size_t(size);
  try {
    if (end > bytes.size()) bytes.resize(end, '\0');
  } catch (const std::bad_alloc&) {
    return SQLITE_FULL;
  }
  std::memcpy(bytes.data() + at, from, std::size_t(size));
  return SQLITE_OK;
}

int truncateFile(sqlite3_file* file, sqlite3_int64 size) {
  RawArray<char>& bytes = bytesOf(file);
  if (size >= 0 && std::size_t(size) < bytes.size()) bytes.resize(std::size_t(size));
  return SQLITE_OK;
}

int syncFile(sqlite3_file*, int) { return SQLITE_OK; }

int sizeOfFile(sqlite3_file* file, sqlite3_int64* size) {
  *size = sqlite3_int64(bytesOf(file).size());
  return SQLITE_OK;
}

int lockFile(sqlite3_file*, int) { return SQLITE_OK; }

int isReserved(sqlite3_file*, int* reserved) {
  *reserved = 0;
  return SQLITE_OK;
}

int controlFile(sqlite3_file*, int, void*) { return SQLITE_NOTFOUND; }
int sectorSize(sqlite3_file*) { return 512; }
int characteristics(sqlite3_file*) { return 0; }

// Version 1: no shared memory, so that the log is read in exclusive mode only, and no mapping.
constexpr sqlite3_io_methods kMethods = {.iVersion = 1,
                                         .xClose = closeFile,
                                         .xRead = readFile,
                                         .xWrite = writeFile,
                                         .xTruncate = truncateFile,
                                         .xSync = syncFile,
                                         .xFileSize = sizeOfFile,
                                         .xLock = lockFile,
                                         .xUnlock = lockFile,
                                         .xCheckReservedLock = isReserved,
                                         .xFileControl = controlFile,
                                         .xSectorSize = sectorSize,
                                         .xDeviceCharacteristics = characteristics,
                                         .xShmMap = nullptr,
                                         .xShmLock = nullptr,
                                         .xShmBarrier = nullptr,
                                         .xShmUnmap = nullptr,
                                         .xFetch = nullptr,
                                         .xUnfetch = nullptr};

int openFile(sqlite3_vfs*, const char*, sqlite3_file* file, int flags, int* given) {
  file->pMethods = nullptr;
  if (!gBytes || !(flags & (SQLITE_OPEN_MAIN_DB | SQLITE_OPEN_WAL))) return SQLITE_CANTOPEN;
  reinterpret_cast<MemoryFile*>(file)->bytes =
      flags & SQLITE_OPEN_WAL ? &gBytes->log : &gBytes->file;
  file->pMethods = &kMethods;
  if (given) *given = flags;
  return SQLITE_OK;
}

int deleteFile(sqlite3_vfs*, const char*, int) { return SQLITE_OK; }

int isThere(sqlite3_vfs*, const char* name, int, int* there) {
  *there = gBytes && std::string_view(name).ends_with("-wal") && !gBytes->log.empty();
  return SQLITE_OK;
}

int fullName(sqlite3_vfs*, const char* name, int size, char* full) {
  ::sqlite3_snprintf(size, full, "%s", name);
  return SQLITE_OK;
}

}  // namespace

void prepareSqliteInChild() {
  ::sqlite3_shutdown();
  ::sqlite3_config(SQLITE_CONFIG_SINGLETHREAD);
  ::sqlite3_initialize();
}

const char* memoryFiles(RecordingBytes& bytes) {
  static sqlite3_vfs vfs;
  gBytes = &bytes;
  gMost = bytes.file.size() + bytes.log.size() + (std::size_t(1) << 20);
  if (::sqlite3_vfs_find(kName)) return kName;
  vfs = *::sqlite3_vfs_find(nullptr);  // clock and random numbers are the system's
  vfs.szOsFile = sizeof(MemoryFile);
  vfs.zName = kName;
  vfs.xOpen = openFile;
  vfs.xDelete = deleteFile;
  vfs.xAccess = isThere;
  vfs.xFullPathname = fullName;
  vfs.pNext = nullptr;
  ::sqlite3_vfs_register(&vfs, 0);
  return kName;
}

}  // namespace resect
