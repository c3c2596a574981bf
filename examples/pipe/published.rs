//! The published sphere-triangle test in Rust without crates, as a program for axiscert's pipe (docs/pipe.md):
//!
//!     rustc --edition 2021 -O -o published_rust published.rs
//!     axiscert generate --family tangent --binary | ./published_rust | axiscert judge --conforms-to published
//!     axiscert run --kernel program:published_rust.json
//!
//! Rust rounds after every operation and fuses none that is not written as mul_add, so the replies are those of
//! axiscert's own kernel, bit for bit. It answers in both precisions.
use std::io::{self, BufReader, BufWriter, Error, ErrorKind, Read, Write};
use std::ops::{Add, Mul, Sub};

const GREATEST_HEADER: usize = 1 << 20; // bytes

trait Real: Copy + Default + PartialOrd + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    fn read(bytes: &[u8]) -> Self;
}
impl Real for f32 {
    fn read(bytes: &[u8]) -> Self {
        f32::from_le_bytes(bytes.try_into().unwrap())
    }
}
impl Real for f64 {
    fn read(bytes: &[u8]) -> Self {
        f64::from_le_bytes(bytes.try_into().unwrap())
    }
}

type Vector<T> = [T; 3];

fn sub<T: Real>(u: Vector<T>, v: Vector<T>) -> Vector<T> {
    [u[0] - v[0], u[1] - v[1], u[2] - v[2]]
}
fn scale<T: Real>(u: Vector<T>, s: T) -> Vector<T> {
    [u[0] * s, u[1] * s, u[2] * s]
}
fn dot<T: Real>(u: Vector<T>, v: Vector<T>) -> T {
    (u[0] * v[0] + u[1] * v[1]) + u[2] * v[2]
}
fn cross<T: Real>(u: Vector<T>, v: Vector<T>) -> Vector<T> {
    [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
}

/// Whether edge uv lies beyond the sphere, and whether the third vertex w does.
fn beyond_edge<T: Real>(u: Vector<T>, v: Vector<T>, w: Vector<T>, uu: T, uv: T, rr: T) -> [bool; 2] {
    let edge = sub(v, u);
    let (d, e) = (uv - uu, dot(edge, edge));
    let q = sub(scale(u, e), scale(edge, d));
    [dot(q, q) > (rr * e) * e, dot(q, sub(scale(w, e), q)) > T::default()]
}

/// The sixteen comparisons; bit i is comparison i in axiscert's order. v: a, b, c, p, r.
fn comparisons<T: Real>(v: &[T]) -> u16 {
    let point = |i: usize| [v[i], v[i + 1], v[i + 2]];
    let p = point(9);
    let (a, b, c, rr) = (sub(point(0), p), sub(point(3), p), sub(point(6), p), v[12] * v[12]);
    let normal = cross(sub(b, a), sub(c, a));
    let (d, e) = (dot(a, normal), dot(normal, normal));
    let (aa, ab, ac, bb, bc, cc) = (dot(a, a), dot(a, b), dot(a, c), dot(b, b), dot(b, c), dot(c, c));
    let first = [d * d > rr * e, aa > rr, ab > aa, ac > aa, bb > rr, ab > bb, bc > bb, cc > rr, ac > cc, bc > cc];
    let edges = [beyond_edge(a, b, c, aa, ab, rr), beyond_edge(b, c, a, bb, bc, rr), beyond_edge(c, a, b, cc, ac, rr)];
    let held = first.iter().chain(edges.iter().flatten());
    held.enumerate().fold(0, |bits, (i, &holds)| bits | (holds as u16) << i)
}

/// An axis separates if all its comparisons hold; sphere and triangle are separated if any axis separates.
fn separated(bits: u16) -> bool {
    [0x0001, 0x000e, 0x0070, 0x0380, 0x0c00, 0x3000, 0xc000].iter().any(|axis| bits & axis == *axis)
}

fn answer<T: Real>(input: &mut impl Read, output: &mut impl Write, count: u64) -> io::Result<()> {
    let size = std::mem::size_of::<T>();
    let mut record = vec![0; 13 * size];
    for _ in 0..count {
        input.read_exact(&mut record)?;
        let query: Vec<T> = record.chunks(size).map(T::read).collect();
        let bits = comparisons(&query);
        let mut reply = [0; 16];
        reply[0] = separated(bits) as u8; // 1 separated, 0 contact
        reply[1] = 1; // flags: comparison bits are given
        reply[8..10].copy_from_slice(&bits.to_le_bytes());
        output.write_all(&reply)?;
    }
    output.flush()
}

fn wrong(what: &str) -> Error {
    Error::new(ErrorKind::InvalidData, what)
}

/// Fills as much of the buffer as there is.
fn read_some(input: &mut impl Read, buffer: &mut [u8]) -> io::Result<usize> {
    let mut done = 0;
    while done < buffer.len() {
        match input.read(&mut buffer[done..])? {
            0 => break,
            got => done += got,
        }
    }
    Ok(done)
}

/// One stream in a pipe; `--kernel program:` writes one after another.
fn streams() -> io::Result<()> {
    let (mut input, mut output) = (BufReader::new(io::stdin().lock()), BufWriter::new(io::stdout().lock()));
    let mut head = [0; 64];
    for stream in 0.. {
        let got = read_some(&mut input, &mut head)?;
        if got == 0 && stream != 0 {
            break;
        }
        if got < head.len() || &head[..8] != b"AXISCERT" {
            return Err(wrong("standard input is not a query stream; axiscert generate --binary makes one"));
        }
        let number = |at: usize| u32::from_le_bytes(head[at..at + 4].try_into().unwrap());
        let (version, precision, header_size) = (number(8), number(12), number(24) as usize);
        let count = u64::from_le_bytes(head[16..24].try_into().unwrap());
        if version != 3 {
            return Err(wrong("the stream is not of version 3"));
        }
        if !(head.len()..=GREATEST_HEADER).contains(&header_size) {
            return Err(wrong("the header is shorter than 64 bytes or longer than 1 MiB"));
        }
        let mut rest = vec![0; header_size - head.len()];
        input.read_exact(&mut rest)?;
        output.write_all(&head)?;
        output.write_all(&rest)?;
        match precision {
            32 => answer::<f32>(&mut input, &mut output, count)?,
            64 => answer::<f64>(&mut input, &mut output, count)?,
            _ => return Err(wrong("the stream's precision is neither 32 nor 64")),
        }
    }
    Ok(())
}

fn main() {
    if let Err(error) = streams() {
        eprintln!("published_rust: {error}"); // standard output is for replies only
        std::process::exit(1);
    }
}
