/* A program for the pipe (docs/pipe.md) that answers sphere-triangle in binary32 as the kernel `published` does, with
 * its comparisons, but for what its argument says: `program MISBEHAVIOUR`. It reads one stream after another, and
 * writes each reply at once. What it does on some queries only, it does on those whose radius is above 1000. */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "kernel/plugin/misbehaving/right.h"

static const char* how;
static int is(const char* name) { return strcmp(how, name) == 0; }

static volatile int* volatile nowhere = NULL;
static volatile unsigned long spun;

static void spin(void) {
  for (;;) ++spun;
}

static void hang(void) {
  for (;;) pause();
}

/* A process in a session of its own that ignores what can be ignored and holds all files open. */
static void leave_process(void) {
  if (fork() != 0) return;
  setsid();
  if (fork() != 0) _exit(0);
  signal(SIGTERM, SIG_IGN);
  signal(SIGHUP, SIG_IGN);
  hang();
}

static void print_error(const char* text) { (void)!write(2, text, strlen(text)); }

/* 64 KiB at a time, as many bytes as the number after the name says. */
static void print_chatter(const char* bytes) {
  static char block[1 << 16];
  long long left = atoll(bytes);
  memset(block, 'x', sizeof block);
  for (; left > 0; left -= (long long)sizeof block) (void)!write(2, block, sizeof block);
  print_error("\nthe last word\n");
}

static void do_to(float r, unsigned long query) {
  if (is("crash-1000") && query == 999) *nowhere = 0;
  if (!misbehaves(r)) return;
  if (is("crash") || is("kept-crash")) *nowhere = 0;
  if (is("exits")) exit(0);
  if (is("exits-3")) {
    print_error("Error: no such shape\n    at somewhere\n\nNode.js v20\n");
    exit(3);
  }
  if (is("hang")) hang();
  if (is("spin")) spin();
  if (is("deaf")) {
    signal(SIGTERM, SIG_IGN);
    leave_process();
    hang();
  }
  if (is("spinning-child")) {
    if (fork() == 0) spin();
    hang();
  }
  if (is("forks")) {
    leave_process();
    abort();
  }
  if (strncmp(how, "chatter-", 8) == 0) {
    print_chatter(how + 8);
    exit(1);
  }
}

/* Whether all of it came. */
static int take(void* to, size_t size) { return fread(to, 1, size, stdin) == size; }
static void put(const void* from, size_t size) { fwrite(from, 1, size, stdout); }

int main(int argc, char** argv) {
  static unsigned char header[1 << 20];
  unsigned long query = 0, stream = 0;
  int keeps_back;
  how = argc > 1 ? argv[1] : "right";
  keeps_back = is("kept-crash");
  if (is("fails")) {
    print_error("Error: Cannot find package 'engine'\n");
    return 1;
  }
  if (is("nothing")) return 0;
  for (; take(header, 64); ++stream) {
    uint32_t header_size;
    uint64_t count, i, due;
    memcpy(&count, header + 16, 8);
    memcpy(&header_size, header + 24, 4);
    if (!take(header + 64, header_size - 64)) return 2;
    if (is("text")) printf("engine 1.0 loaded\n");
    if (is("wrong-header")) header[40] ^= 1;
    put(header, header_size);
    fflush(stdout);
    due = is("too-little") && count > 0 ? count - 1 : count;
    for (i = 0; i < count; ++i, ++query) {
      float v[13];
      uint64_t bits = 0;
      unsigned char reply[16] = {0, 1}; /* with comparison bits */
      if (!take(v, sizeof v)) return 2;
      if (i >= due) return 0;
      do_to(v[12], query);
      reply[0] = (unsigned char)published_binary32(v, v + 3, v + 6, v + 9, v[12], &bits);
      memcpy(reply + 8, &bits, 8);
      if (is("garbage")) memset(reply, 0xee, sizeof reply);
      if (is("no-verdict") && misbehaves(v[12])) reply[0] = 7;
      if (is("no-bits")) memset(reply + 1, 0, sizeof reply - 1);
      if (is("changes") && misbehaves(v[12]) && stream % 2 == 1) reply[0] ^= 1;
      if (is("first-differs") && i == 0 && count > 1 && count < 1000) reply[0] ^= 1;
      put(reply, sizeof reply);
      if (!keeps_back) fflush(stdout);
    }
    if (is("too-much")) put("\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0", 16);
    fflush(stdout);
    if (is("once")) return 0;
    if (is("once-badly")) return 4;
  }
  if (is("stays")) hang(); /* at the end of its input */
  return 0;
}
