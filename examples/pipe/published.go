// The published sphere-triangle test in Go, as a program for axiscert's pipe (docs/pipe.md):
//
//	go build -o published_go published.go
//	axiscert generate --family tangent --binary | ./published_go | axiscert judge --conforms-to published
//	axiscert run --kernel program:published_go.json
//
// A Go compiler may fuse x*y + z into one operation with one rounding, and does so on several architectures, but not
// across a conversion: every product that is added is converted to its own type. So the replies are those of
// axiscert's own kernel, bit for bit. It answers in both precisions.
package main

import (
	"bufio"
	"encoding/binary"
	"errors"
	"fmt"
	"io"
	"math"
	"os"
)

const greatestHeader = 1 << 20 // bytes

type real interface{ float32 | float64 }

type vector[T real] struct{ x, y, z T }

func (u vector[T]) sub(v vector[T]) vector[T] { return vector[T]{u.x - v.x, u.y - v.y, u.z - v.z} }
func (u vector[T]) scale(s T) vector[T]       { return vector[T]{T(u.x * s), T(u.y * s), T(u.z * s)} }
func (u vector[T]) dot(v vector[T]) T         { return (T(u.x*v.x) + T(u.y*v.y)) + T(u.z*v.z) }
func (u vector[T]) cross(v vector[T]) vector[T] {
	return vector[T]{T(u.y*v.z) - T(u.z*v.y), T(u.z*v.x) - T(u.x*v.z), T(u.x*v.y) - T(u.y*v.x)}
}

// Whether edge uv lies beyond the sphere, and whether the third vertex w does.
func beyondEdge[T real](u, v, w vector[T], uu, uv, rr T) [2]bool {
	edge := v.sub(u)
	d, e := uv-uu, edge.dot(edge)
	q := u.scale(e).sub(edge.scale(d))
	return [2]bool{q.dot(q) > T(rr*e)*e, q.dot(w.scale(e).sub(q)) > 0}
}

// The sixteen comparisons; bit i is comparison i in axiscert's order. v: a, b, c, p, r.
func comparisons[T real](v [13]T) uint16 {
	p, rr := vector[T]{v[9], v[10], v[11]}, T(v[12]*v[12])
	a, b, c := vector[T]{v[0], v[1], v[2]}.sub(p), vector[T]{v[3], v[4], v[5]}.sub(p), vector[T]{v[6], v[7], v[8]}.sub(p)
	normal := b.sub(a).cross(c.sub(a))
	d, e := a.dot(normal), normal.dot(normal)
	aa, ab, ac, bb, bc, cc := a.dot(a), a.dot(b), a.dot(c), b.dot(b), b.dot(c), c.dot(c)
	ofAB, ofBC, ofCA := beyondEdge(a, b, c, aa, ab, rr), beyondEdge(b, c, a, bb, bc, rr), beyondEdge(c, a, b, cc, ac, rr)
	var bits uint16
	for i, holds := range [16]bool{d*d > rr*e, aa > rr, ab > aa, ac > aa, bb > rr, ab > bb, bc > bb, cc > rr, ac > cc, bc > cc,
		ofAB[0], ofAB[1], ofBC[0], ofBC[1], ofCA[0], ofCA[1]} {
		if holds {
			bits |= 1 << i
		}
	}
	return bits
}

// An axis separates if all its comparisons hold; sphere and triangle are separated if any axis separates.
func separated(bits uint16) bool {
	for _, axis := range [7]uint16{0x0001, 0x000e, 0x0070, 0x0380, 0x0c00, 0x3000, 0xc000} {
		if bits&axis == axis {
			return true
		}
	}
	return false
}

// Answers `count` queries of numbers of `size` bytes, of which `number` reads one.
func answer[T real](in io.Reader, out io.Writer, count uint64, size int, number func([]byte) T) error {
	record := make([]byte, 13*size)
	for ; count != 0; count-- {
		if _, err := io.ReadFull(in, record); err != nil {
			return errors.New("a query is cut short")
		}
		var query [13]T
		for i := range query {
			query[i] = number(record[i*size:])
		}
		bits := comparisons(query)
		reply := [16]byte{1: 1, 8: byte(bits), 9: byte(bits >> 8)} // contact; flags: comparison bits are given
		if separated(bits) {
			reply[0] = 1
		}
		if _, err := out.Write(reply[:]); err != nil {
			return err
		}
	}
	return nil
}

// One stream, its header and a reply for each query; io.EOF where there is none.
func stream(in io.Reader, out *bufio.Writer) error {
	head := make([]byte, 64)
	if _, err := io.ReadFull(in, head); err == io.EOF {
		return io.EOF
	} else if err != nil || string(head[:8]) != "AXISCERT" {
		return errors.New("standard input is not a query stream; axiscert generate --binary makes one")
	}
	order := binary.LittleEndian
	version, precision := order.Uint32(head[8:]), order.Uint32(head[12:])
	count, headerSize := order.Uint64(head[16:]), order.Uint32(head[24:])
	if version != 3 {
		return errors.New("the stream is not of version 3")
	}
	if headerSize < 64 || headerSize > greatestHeader {
		return errors.New("the header is shorter than 64 bytes or longer than 1 MiB")
	}
	rest := make([]byte, headerSize-64)
	if _, err := io.ReadFull(in, rest); err != nil {
		return errors.New("the header is cut short")
	}
	out.Write(append(head, rest...)) // an error stays until Flush
	var err error
	switch precision {
	case 32:
		err = answer(in, out, count, 4, func(b []byte) float32 { return math.Float32frombits(order.Uint32(b)) })
	case 64:
		err = answer(in, out, count, 8, func(b []byte) float64 { return math.Float64frombits(order.Uint64(b)) })
	default:
		err = fmt.Errorf("the stream's precision is %d; it is 32 or 64", precision)
	}
	if err != nil {
		return err
	}
	return out.Flush()
}

// One stream in a pipe; `--kernel program:` writes one after another.
func main() {
	in, out := bufio.NewReaderSize(os.Stdin, 1<<16), bufio.NewWriterSize(os.Stdout, 1<<16)
	for streams := 0; ; streams++ {
		err := stream(in, out)
		if err == io.EOF && streams != 0 {
			return
		}
		if err == io.EOF {
			err = errors.New("standard input is empty; axiscert generate --binary makes a query stream")
		}
		if err != nil {
			fmt.Fprintln(os.Stderr, "published_go:", err) // standard output is for replies only
			os.Exit(1)
		}
	}
}
