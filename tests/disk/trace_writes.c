// SPDX-License-Identifier: BSD-3-Clause
//
// Preloaded before a program, writes down what it does to the files of one folder: what it creates,
// writes, syncs, renames and removes, in order, so that simulated_disk.py can tell what a disk may
// hold after a loss of power. It can also let a call fail as a bad disk does.
//
//   PALPATE_DISK_FOLDER   the folder, absolute
//   PALPATE_DISK_TRACE    the file to append to
//   PALPATE_DISK_FAIL     interrupt-sync: every second fsync fails with EINTR
//                         folder-sync:    fsync of the folder fails with EIO
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { kMostFiles = 4096 };

static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static struct {
  ino_t inode;
  int number;
} files[kMostFiles];
static int file_count, next_number, sync_count;

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

static const char* folder(void) { return getenv("PALPATE_DISK_FOLDER"); }

static int fails(const char* how) {
  const char* wanted = getenv("PALPATE_DISK_FAIL");
  return wanted && strcmp(wanted, how) == 0;
}

static void put(const char* line, const void* data, size_t size) {
  const char* path = getenv("PALPATE_DISK_TRACE");
  if (!path) return;
  const int trace = REAL(open)(path, O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0600);
  if (trace < 0) abort();
  char* all = malloc(strlen(line) + size);
  memcpy(all, line, strlen(line));
  if (size) memcpy(all + strlen(line), data, size);
  const size_t length = strlen(line) + size;
  if (REAL(write)(trace, all, length) != (ssize_t)length) abort();
  free(all);
  close(trace);
}

/// The name of a path within the folder, or null for one that lies elsewhere.
static const char* name_in_folder(const char* path) {
  const char* wanted = folder();
  if (!wanted) return NULL;
  const size_t length = strlen(wanted);
  if (strncmp(path, wanted, length) != 0 || path[length] != '/') return NULL;
  return strchr(path + length + 1, '/') ? NULL : path + length + 1;
}

static int is_folder(int descriptor) {
  struct stat here, there;
  return folder() && fstat(descriptor, &here) == 0 && stat(folder(), &there) == 0 &&
         here.st_ino == there.st_ino && here.st_dev == there.st_dev;
}

/// The number of an open file of the folder, -1 for any other.
static int find_number(int descriptor) {
  struct stat status;
  if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return -1;
  for (int k = file_count - 1; k >= 0; --k) {
    if (files[k].inode == status.st_ino) return files[k].number;
  }
  return -1;
}

static void note_open(int descriptor, const char* name, int created) {
  struct stat status;
  if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return;
  char line[600];
  if (!created && find_number(descriptor) >= 0) return;
  if (file_count == kMostFiles) abort();
  files[file_count].inode = status.st_ino;
  files[file_count++].number = next_number;
  snprintf(line, sizeof line, "%s %d %s\n", created ? "create" : "known", next_number++, name);
  put(line, NULL, 0);
}

static int open_noted(const char* path, int flags, mode_t mode) {
  const char* name = name_in_folder(path);
  const int writes = (flags & O_ACCMODE) != O_RDONLY;
  if (!name || !writes) return REAL(open)(path, flags, mode);
  pthread_mutex_lock(&mutex);
  struct stat before;
  const int created = lstat(path, &before) != 0;
  const int descriptor = REAL(open)(path, flags, mode);
  if (descriptor >= 0) note_open(descriptor, name, created);
  if (descriptor >= 0 && (flags & O_TRUNC) && !created) {
    char line[64];
    snprintf(line, sizeof line, "truncate %d 0\n", find_number(descriptor));
    put(line, NULL, 0);
  }
  pthread_mutex_unlock(&mutex);
  return descriptor;
}

static mode_t take_mode(int flags, va_list list) {
  return flags & (O_CREAT | O_TMPFILE) ? va_arg(list, mode_t) : 0;
}

#define OPEN(name)                              \
  int name(const char* path, int flags, ...) {  \
    va_list list;                               \
    va_start(list, flags);                      \
    const mode_t mode = take_mode(flags, list); \
    va_end(list);                               \
    return open_noted(path, flags, mode);       \
  }
OPEN(open)
OPEN(open64)

ssize_t write(int descriptor, const void* data, size_t size) {
  pthread_mutex_lock(&mutex);
  const int number = folder() ? find_number(descriptor) : -1;
  const off_t at = number < 0 ? 0 : lseek(descriptor, 0, SEEK_CUR);
  const ssize_t done = REAL(write)(descriptor, data, size);
  if (number >= 0 && done > 0) {
    char line[96];
    snprintf(line, sizeof line, "write %d %lld %lld\n", number, (long long)at, (long long)done);
    put(line, data, (size_t)done);
  }
  pthread_mutex_unlock(&mutex);
  return done;
}

static void note_truncate(int descriptor, off_t size) {
  char line[64];
  pthread_mutex_lock(&mutex);
  const int number = find_number(descriptor);
  snprintf(line, sizeof line, "truncate %d %lld\n", number, (long long)size);
  if (number >= 0) put(line, NULL, 0);
  pthread_mutex_unlock(&mutex);
}

#define TRUNCATE(name)                            \
  int name(int descriptor, off_t size) {          \
    const int done = REAL(name)(descriptor, size); \
    if (done == 0) note_truncate(descriptor, size); \
    return done;                                  \
  }
TRUNCATE(ftruncate)
TRUNCATE(ftruncate64)

int fsync(int descriptor) {
  if (fails("interrupt-sync") && sync_count++ % 2 == 0) {
    errno = EINTR;
    return -1;
  }
  const int whole = is_folder(descriptor);
  if (whole && fails("folder-sync")) {
    errno = EIO;
    return -1;
  }
  const int done = REAL(fsync)(descriptor);
  pthread_mutex_lock(&mutex);
  const int number = whole ? -1 : find_number(descriptor);
  char line[64] = "sync-folder\n";
  if (!whole) snprintf(line, sizeof line, "sync %d\n", number);
  if (done == 0 && (whole || number >= 0)) put(line, NULL, 0);
  pthread_mutex_unlock(&mutex);
  return done;
}

int fdatasync(int descriptor) { return fsync(descriptor); }

static void note_names(const char* what, const char* one, const char* other) {
  char line[1200];
  if (!one || (other && !*other)) return;
  snprintf(line, sizeof line, "%s %s%s%s\n", what, one, other ? " " : "", other ? other : "");
  pthread_mutex_lock(&mutex);
  put(line, NULL, 0);
  pthread_mutex_unlock(&mutex);
}

int rename(const char* old, const char* new) {
  const int done = REAL(rename)(old, new);
  if (done == 0 && name_in_folder(new)) note_names("rename", name_in_folder(old), name_in_folder(new));
  return done;
}

int renameat(int from, const char* old, int to, const char* new) {
  if (name_in_folder(old)) return rename(old, new);
  return REAL(renameat)(from, old, to, new);
}

int unlink(const char* path) {
  const int done = REAL(unlink)(path);
  if (done == 0) note_names("unlink", name_in_folder(path), NULL);
  return done;
}

int unlinkat(int from, const char* path, int flags) {
  const int inside = is_folder(from);
  const int done = REAL(unlinkat)(from, path, flags);
  if (done == 0 && (inside || name_in_folder(path))) {
    note_names("unlink", inside ? path : name_in_folder(path), NULL);
  }
  return done;
}
