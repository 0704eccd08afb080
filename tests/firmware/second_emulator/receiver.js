// SPDX-License-Identifier: BSD-3-Clause
// The receiver of the UART as the data sheet of the ATmega328P has it (DS40002061B, 20.7). avr8js
// 0.21.1 keeps one byte where the chip keeps two and a third in its shift register, and forgets a
// received byte at every write of UCSR0B, with which a program switches its transmitter.
const UCSR0A = 0xc0, UCSR0B = 0xc1, UDR0 = 0xc6;
const DATA_OVERRUN = 1 << 3, MOST_HELD = 3;

export class Receiver {
  constructor(cpu, usart, byteCycles) {
    this.cpu = cpu;
    this.interrupt = usart.RXC;
    this.byteCycles = byteCycles;
    this.coming = [];
    this.held = [];
    this.wireFree = 0;
    this.overruns = 0;   // bytes that found no room
    this.worstDelay = 0; // [cycles] from the end of a byte until the program read it
    const write = cpu.writeHooks[UCSR0B];
    cpu.writeHooks[UCSR0B] = (...call) => {
      write(...call);
      if (this.held.length > 0) cpu.setInterruptFlag(this.interrupt);
      return true;
    };
    cpu.readHooks[UDR0] = () => this.read();
  }

  /// Bytes that now enter the wire, one after the other.
  send(bytes) {
    this.wireFree = Math.max(this.wireFree, this.cpu.cycles);
    this.coming.push(...bytes);
  }

  /// The cycle at which the next byte begins; null when none comes.
  next() {
    return this.coming.length > 0 ? this.wireFree : null;
  }

  /// Begins a byte that is due.
  feed() {
    if (this.coming.length === 0 || this.cpu.cycles < this.wireFree) return;
    const byte = this.coming.shift();
    this.wireFree += this.byteCycles;
    const full = this.held.length >= MOST_HELD;
    this.cpu.addClockEvent(() => this.arrive(byte, full), this.wireFree - this.cpu.cycles);
  }

  arrive(byte, full) {
    if (full) {
      this.overruns++;
      this.cpu.data[UCSR0A] |= DATA_OVERRUN;
      return;
    }
    this.held.push([byte, this.cpu.cycles]);
    this.cpu.setInterruptFlag(this.interrupt);
  }

  read() {
    if (this.held.length === 0) return 0;
    const [byte, end] = this.held.shift();
    this.worstDelay = Math.max(this.worstDelay, this.cpu.cycles - end);
    this.cpu.data[UCSR0A] &= ~DATA_OVERRUN;
    if (this.held.length === 0) this.cpu.clearInterrupt(this.interrupt);
    return byte;
  }
}
