//! Word addresses: letters such as `X`, the block skip `/`, and multi-letter addresses such as `SPOS`.

use core::fmt;

/// Address of an NC word.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum Address {
    /// `A`.
    A,
    /// `B`.
    B,
    /// `C`.
    C,
    /// `D`.
    D,
    /// `E`.
    E,
    /// `F`.
    F,
    /// `G`.
    G,
    /// `H`.
    H,
    /// `I`.
    I,
    /// `J`.
    J,
    /// `K`.
    K,
    /// `L`.
    L,
    /// `M`.
    M,
    /// `N`.
    N,
    /// `O`.
    O,
    /// `P`.
    P,
    /// `Q`.
    Q,
    /// `R`.
    R,
    /// `S`.
    S,
    /// `T`.
    T,
    /// `U`.
    U,
    /// `V`.
    V,
    /// `W`.
    W,
    /// `X`.
    X,
    /// `Y`.
    Y,
    /// `Z`.
    Z,
    /// `/`: optional block skip from here to the end of the block.
    Skip,
    /// A G code or statement written as a name; the word's value is its index in [`Names::codes`](super::syntax::Names::codes).
    Name,
    /// Radius of an arc.
    Cr,
    /// Highest spindle speed under constant surface speed.
    Lims,
    /// Spindle position.
    Spos,
    /// Opening angle of an arc in degrees.
    Ar,
    /// Polar angle.
    Ap,
    /// Polar radius.
    Rp,
    /// Start angle of a thread.
    Sf,
    /// Chamfer.
    Chf,
    /// Chamfer by the length of its legs.
    Chr,
    /// Rounded corner.
    Rnd,
    /// Angle of a contour.
    Ang,
    /// Feed of chamfers and rounded corners.
    Frc,
    /// Angle of a programmable rotation.
    Rpl,
    /// Rounded corners from here on.
    Rndm,
    /// Feed of all chamfers and rounded corners.
    Frcm,
}

use Address::*;

/// The addresses of one letter, from A.
pub const LETTERS: [Address; 26] = [A, B, C, D, E, F, G, H, I, J, K, L, M, N, O, P, Q, R, S, T, U, V, W, X, Y, Z];

impl Address {
    /// The address of a letter, small or capital; `None` for other bytes.
    #[inline]
    pub const fn of(byte: u8) -> Option<Address> {
        let at = (byte | 0x20).wrapping_sub(b'a') as usize;
        if at < LETTERS.len() { Some(LETTERS[at]) } else { None }
    }

    /// Whether the address has several letters.
    #[inline]
    pub const fn is_long(self) -> bool {
        self as u8 > Skip as u8
    }

    /// The letter; `/` for a block skip, `None` for an address of several letters.
    pub const fn letter(self) -> Option<char> {
        match self as u8 {
            at @ 0..26 => Some((b'A' + at) as char),
            26 => Some('/'),
            _ => None,
        }
    }

    /// The address of several letters as in a program; empty for the others.
    const fn long_name(self) -> &'static str {
        match self {
            Name => "NAME",
            Cr => "CR",
            Lims => "LIMS",
            Spos => "SPOS",
            Ar => "AR",
            Ap => "AP",
            Rp => "RP",
            Sf => "SF",
            Chf => "CHF",
            Chr => "CHR",
            Rnd => "RND",
            Ang => "ANG",
            Frc => "FRC",
            Rpl => "RPL",
            Rndm => "RNDM",
            Frcm => "FRCM",
            _ => "",
        }
    }

    /// The letter as a byte; `?` for an address of several letters.
    pub const fn byte(self) -> u8 {
        match self.letter() {
            Some(letter) => letter as u8,
            None => b'?',
        }
    }

    /// Distance from another address in the alphabet, 1 for Y from X; `None` if it comes earlier or either has several letters.
    #[inline]
    pub const fn after(self, first: Address) -> Option<usize> {
        match (self as u8).checked_sub(first as u8) {
            Some(distance) if (self as u8) < 26 => Some(distance as usize),
            _ => None,
        }
    }
}

impl fmt::Display for Address {
    /// Writes the address as in a program: `X`, `/`, `CR`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.letter() {
            Some(letter) => write!(f, "{letter}"),
            None => f.write_str(self.long_name()),
        }
    }
}

/// A set of addresses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct AddressSet(u64);

impl AddressSet {
    /// No address.
    pub const EMPTY: AddressSet = AddressSet(0);

    /// The addresses of some letters: `AddressSet::letters("XYZ")`.
    pub const fn letters(letters: &str) -> AddressSet {
        let bytes = letters.as_bytes();
        let (mut set, mut at) = (AddressSet::EMPTY, 0);
        while at < bytes.len() {
            match Address::of(bytes[at]) {
                Some(address) => set = set.with(address),
                None => panic!("no letter"),
            }
            at += 1;
        }
        set
    }

    /// The set and one more address.
    #[inline]
    pub const fn with(self, address: Address) -> AddressSet {
        AddressSet(self.0 | 1 << address as u8)
    }

    /// The set without an address.
    pub const fn without(self, address: Address) -> AddressSet {
        AddressSet(self.0 & !(1 << address as u8))
    }

    /// Adds an address and returns whether it is new.
    #[inline]
    pub const fn insert(&mut self, address: Address) -> bool {
        let before = self.0;
        self.0 |= 1 << address as u8;
        before != self.0
    }

    /// Whether an address is in the set.
    #[inline]
    pub const fn contains(self, address: Address) -> bool {
        self.0 >> address as u8 & 1 != 0
    }

    /// Addresses of both sets.
    #[inline]
    pub const fn and(self, other: AddressSet) -> AddressSet {
        AddressSet(self.0 & other.0)
    }

    /// Addresses of either set.
    #[inline]
    pub const fn or(self, other: AddressSet) -> AddressSet {
        AddressSet(self.0 | other.0)
    }

    /// Whether every address of this set is in the other.
    #[inline]
    pub const fn within(self, other: AddressSet) -> bool {
        self.0 & !other.0 == 0
    }

    /// The first address in the order of [`Address`].
    pub fn first(self) -> Option<Address> {
        LETTERS.into_iter().find(|address| self.contains(*address))
    }

    /// Whether no address is in the set.
    #[inline]
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }
}

impl FromIterator<Address> for AddressSet {
    fn from_iter<T: IntoIterator<Item = Address>>(addresses: T) -> AddressSet {
        addresses.into_iter().fold(AddressSet::EMPTY, AddressSet::with)
    }
}
